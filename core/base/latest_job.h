// One worker thread that always works on the newest request. The interface submits, polls
// once a frame and waits briefly at most; a command line submits and waits. Each result carries the
// revision of the request it was made for.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace nacre {

template <class Request, class Result>
class LatestJob {
  public:
    using Publish = std::function<void(Result)>;
    // Called on the worker thread. May publish several results, a quick one first; returns or throws
    // soon after a stop is requested.
    using Work = std::function<void(const Request&, std::stop_token, const Publish&)>;

    // Either a result or what the work threw.
    struct Published {
        std::uint64_t revision = 0;
        std::optional<Result> result;
        std::exception_ptr error;
    };

    // `notify` is called on the worker's thread after each publication, and when nothing more is to come.
    explicit LatestJob(Work work, std::function<void()> notify = {})
        : work_(std::move(work)),
          notify_(std::move(notify)),
          thread_([this](std::stop_token closing) { loop(closing); }) {}

    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    ~LatestJob() {
        thread_.request_stop();
        const std::lock_guard lock(mutex_);
        running_stop_.request_stop();
    }

    // Replaces a waiting request. Stops the running one only once it has published something: while
    // a slider is dragged requests come faster than results, and none would ever arrive otherwise.
    std::uint64_t submit(Request request) {
        std::stop_source stop;  // here, where it may throw: the worker allocates nothing outside its work
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(request);
        waiting_stop_ = std::move(stop);
        ++submitted_;
        if (running_has_published_) running_stop_.request_stop();
        changed_.notify_all();
        return submitted_;
    }

    // The newest result or error since the last call. An answer to the newest request may take up to
    // `patience` to come.
    std::optional<Published> poll(std::chrono::milliseconds patience = {}) {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, patience, [this] {
            return (!waiting_ && !running_) || (newest_ && newest_->revision == submitted_);
        });
        return std::exchange(newest_, std::nullopt);
    }

    bool busy() const {
        const std::lock_guard lock(mutex_);
        return waiting_.has_value() || running_;
    }

    // Returns when nothing runs and nothing waits.
    void wait() const {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !waiting_ && !running_; });
    }

  private:
    void loop(std::stop_token closing) {
        std::unique_lock lock(mutex_);
        while (changed_.wait(lock, closing, [this] { return waiting_.has_value(); }) &&
               !closing.stop_requested()) {
            const Request request = std::move(*waiting_);
            waiting_.reset();
            running_ = true;
            running_has_published_ = false;
            running_stop_ = std::move(waiting_stop_);
            const std::uint64_t revision = submitted_;
            const std::stop_token stop = running_stop_.get_token();
            lock.unlock();
            run(request, revision, stop);
            lock.lock();
            running_ = false;
            running_has_published_ = false;
            changed_.notify_all();
            if (waiting_ || !notify_) continue;
            lock.unlock();
            notify_();
            lock.lock();
        }
    }

    void run(const Request& request, std::uint64_t revision, const std::stop_token& stop) {
        std::exception_ptr error;
        try {
            work_(request, stop, [this, revision](Result result) {
                publish({.revision = revision, .result = std::move(result), .error = nullptr});
            });
        } catch (...) {
            error = std::current_exception();
        }
        // After the handler, so that nobody else holds what is handed over. What a stopped work throws only
        // says that it was stopped.
        if (error && !stop.stop_requested())
            publish({.revision = revision, .result = std::nullopt, .error = std::move(error)});
    }

    void publish(Published published) {
        {
            const std::lock_guard lock(mutex_);
            newest_ = std::move(published);
            running_has_published_ = true;
            changed_.notify_all();
            if (waiting_) running_stop_.request_stop();
        }
        if (notify_) notify_();
    }

    const Work work_;
    const std::function<void()> notify_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::optional<Request> waiting_;
    std::optional<Published> newest_;
    std::uint64_t submitted_ = 0;
    bool running_ = false;
    bool running_has_published_ = false;
    std::stop_source waiting_stop_{std::nostopstate}, running_stop_{std::nostopstate};
    std::jthread thread_;  // last: it starts when all of the above exists, and joins first
};

}  // namespace nacre
