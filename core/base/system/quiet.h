#pragma once

namespace nacre {

// While it lives, what this thread writes to the C library's `stderr` is discarded: decoders print their
// complaints there, and we report an error of our own. Other threads, and what is written to the descriptor
// or to std::cerr, are not touched.
class Quiet {
  public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

}  // namespace nacre
