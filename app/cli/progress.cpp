#include "app/cli/progress.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/system/standard_streams.h"

namespace nacre::cli {
namespace {

constexpr int bar_length = 30;  // characters
constexpr auto first_after = std::chrono::milliseconds(500);
constexpr auto between = std::chrono::milliseconds(100);

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(error_is_terminal()), next_(Clock::now() + first_after) {}

Progress::~Progress() {
    if (drawn_) write_message("\r\033[K", between);
}

void Progress::report(double done) {
    if (!terminal_ || Clock::now() < next_) return;
    next_ = Clock::now() + between;
    drawn_ = true;
    const double part = std::clamp(done, 0.0, 1.0);
    const int filled = static_cast<int>(std::lround(part * bar_length));
    write_message(fmt::format("\r{} [{:#<{}}{:.<{}}] {:3.0f} %", what_, "", filled, "", bar_length - filled,
                              100 * part),
                  between);
}

}  // namespace nacre::cli
