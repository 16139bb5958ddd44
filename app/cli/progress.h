// A bar on standard error while something takes long; only where standard error is a terminal.
#pragma once

#include <chrono>
#include <string>

namespace nacre::cli {

class Progress {
  public:
    explicit Progress(std::string what);
    ~Progress();  // clears the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `done` in [0, 1]; drawn at most ten times a second, and not in the first half.
    void report(double done);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point next_;
};

}  // namespace nacre::cli
