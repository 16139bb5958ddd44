// Standard error: what went wrong, and how far the work is. Whether anybody reads it changes nothing.
#pragma once

#include <chrono>
#include <string_view>

namespace nacre::cli {

// `nacre-cli: WHAT`, on one line.
void complain(std::string_view what);

// The text as it is; what cannot be written within the time is lost.
void write_message(std::string_view text, std::chrono::milliseconds patience);

}  // namespace nacre::cli
