// Times of this process, in seconds.
#pragma once

namespace nacre {

// Of the processor, all threads together.
double processor_seconds();

// On the clock, since the process began.
double seconds_since_start();

}  // namespace nacre
