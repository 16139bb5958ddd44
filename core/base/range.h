#pragma once

namespace nacre {

// From `low` to `high`, both included.
struct Range {
    double low;
    double high;
};

}  // namespace nacre
