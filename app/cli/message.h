#pragma once

#include <string_view>

namespace nacre::cli {

// `nacre-cli: WHAT`, on one line of standard error. Whether anybody reads it changes nothing.
void complain(std::string_view what);

// The same of what is done nonetheless.
void warn(std::string_view about, std::string_view message);

}  // namespace nacre::cli
