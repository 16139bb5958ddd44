// How nacre-cli ends on a signal.
#pragma once

#include "tests/cli/child_process.h"

namespace nacre::test {

// Exit code 1, the one line that says so, and the end within a second of `options.signal`. Load on the
// machine only ever delays, so that one of three goes has to be within the second; all have to end rightly.
void check_stops_within_a_second(const std::vector<std::string>& arguments, const ChildOptions& options);

}  // namespace nacre::test
