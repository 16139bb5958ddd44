#include "app/designer/background_task.h"

#include <exception>
#include <utility>

namespace nacre {

void BackgroundTask::start(Work work) {
    state_ = std::make_shared<State>();
    thread_ = std::jthread([work = std::move(work), state = state_](const std::stop_token& stop) {
        try {
            state->ended.message = work(stop, [&](double done) { state->progress = done; });
        } catch (const std::exception& error) {
            if (!stop.stop_requested()) state->ended.problem = error.what();
        }
        state->done = true;
    });
}

std::optional<BackgroundTask::Ended> BackgroundTask::poll() {
    if (!state_ || !state_->done) return {};
    thread_.join();
    return std::move(std::exchange(state_, nullptr)->ended);
}

}  // namespace nacre
