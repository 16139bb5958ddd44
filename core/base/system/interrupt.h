// Ctrl+C, SIGTERM and a closed terminal (SIGHUP).
#pragma once

#include <csignal>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>

namespace nacre {

struct Stopped : std::runtime_error {
    Stopped() : std::runtime_error("stopped") {}
};

// The three signals become a request to stop. Work that has not answered it within a fifth of a second (a
// driver that draws, a reader that decodes) is killed, but never while files are
// being written. Only one at a time, made before any other thread, since threads inherit that the signals
// wait.
class Interrupt {
  public:
    // `last_words`: what is written to standard error when work is killed.
    explicit Interrupt(std::string last_words);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    void check() const {
        if (source_.stop_requested()) throw Stopped();
    }

    // Throws Stopped instead of beginning when a stop was requested; once begun, the writing ends whole.
    void write_files(const std::function<void()>& write);

  private:
    void watch(const std::stop_token& closing);

    sigset_t signals_{};
    const std::string last_words_;
    std::stop_source source_;
    std::mutex writing_;
    std::jthread watcher_;
};

}  // namespace nacre
