#include "app/designer/background_task.h"

#include <utility>

#include "core/base/error.h"

namespace nacre {

void BackgroundTask::start(Work work) {
    auto state = std::make_shared<State>();
    thread_ = std::jthread([work = std::move(work), state](const std::stop_token& stop) {
        try {
            state->message = work(stop, [&](double done) { state->progress = done; });
        } catch (...) {
            // In words by poll(): where memory is short there may be none for them here.
            if (!stop.stop_requested()) state->error = std::current_exception();
        }
        state->done = true;
    });
    state_ = std::move(state);  // busy once the thread is there
}

std::optional<BackgroundTask::Ended> BackgroundTask::poll() {
    if (!state_ || !state_->done) return {};
    thread_.join();
    const std::shared_ptr<State> ended = std::exchange(state_, nullptr);
    return Ended{std::move(ended->message), ended->error ? problem_line(ended->error) : std::string()};
}

}  // namespace nacre
