#pragma once

namespace nacre {

// While it lives, nothing that this thread writes to the C library's `stderr` appears: decoders print what
// they dislike, which is told by an error of ours. Other threads, and what is written to the descriptor or to
// std::cerr, are not touched.
class Quiet {
  public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

}  // namespace nacre
