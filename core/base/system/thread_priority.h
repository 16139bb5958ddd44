#pragma once

namespace nacre {

// Of a worker whose answer is waited for: below drawing.
inline constexpr int worker_niceness = 10;

// Sets the niceness (nice(2), 0 to 19) of the calling thread, and so of the threads that it starts.
void set_niceness(int niceness);

}  // namespace nacre
