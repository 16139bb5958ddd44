#pragma once

#include <stdexcept>

namespace nacre {

// A picture that cannot be used, with the reason.
struct PictureProblem : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace nacre
