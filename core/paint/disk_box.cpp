#include "core/paint/disk_box.h"

#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace nacre {
namespace {

constexpr double thinnest = 4e-3;  // half a side: a texel of a painted layer

// How many times longer a side becomes, of that half length.
double kept_open(double times, double half) {
    const double least = thinnest / half;
    return std::abs(times) < least ? std::copysign(least, times) : times;
}

}  // namespace

dvec2 DiskBox::own(dvec2 at) const { return glm::inverse(glm::dmat2(right, up)) * (at - middle); }

DiskBox turned(const DiskBox& box, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat2 turn{{c, s}, {-s, c}};
    return {box.middle, turn * box.right, turn * box.up};
}

DiskBox pulled(const DiskBox& box, dvec2 handle, dvec2 to, bool in_ratio) {
    const dvec2 own = box.own(to);
    // Of the way from what stays to the handle, which is 2 of its own.
    dvec2 times(1);
    if (handle.x != 0) times.x = kept_open((own.x + handle.x) / (2 * handle.x), glm::length(box.right));
    if (handle.y != 0) times.y = kept_open((own.y + handle.y) / (2 * handle.y), glm::length(box.up));
    if (in_ratio) {
        if (handle.x == 0)
            times.x = std::abs(times.y);
        else if (handle.y == 0)
            times.y = std::abs(times.x);
        else
            times.x = times.y = std::abs(times.x) > std::abs(times.y) ? times.x : times.y;
    }
    return {box.at(handle * (times - 1.0)), box.right * times.x, box.up * times.y};
}

}  // namespace nacre
