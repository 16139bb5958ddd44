// One piece of work at a time on a thread of its own, with progress and a way to stop it.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace nacre {

class BackgroundTask {
  public:
    // Returns what is told of it when it is done; throws what went wrong.
    using Work =
        std::function<std::string(const std::stop_token& stop, const std::function<void(double)>& progress)>;

    // Only while none runs.
    void start(Work work);

    bool busy() const { return state_ != nullptr; }
    double progress() const { return state_ ? state_->progress.load() : 0; }  // 0 to 1
    void cancel() { thread_.request_stop(); }

    struct Ended {
        std::string message;
        std::string problem;  // one line; both are empty where it was stopped
    };
    // Once, when it has ended.
    std::optional<Ended> poll();

  private:
    struct State {
        std::atomic<double> progress = 0;
        std::atomic<bool> done = false;
        std::string message;
        std::exception_ptr error;
    };
    std::shared_ptr<State> state_;
    std::jthread thread_;
};

}  // namespace nacre
