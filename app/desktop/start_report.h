// How long the program takes from its start to the first shaded picture: what tests/bench/start.sh reads.
#pragma once

namespace nacre {

// Prints "STAGE WALL CPU" to standard output: seconds since the process began, of the clock on the wall (to
// a hundredth, as the kernel notes the beginning) and of the processor, all threads together.
void report_stage(const char* stage);

}  // namespace nacre
