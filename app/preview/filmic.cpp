#include "app/preview/filmic.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

constexpr double white = 11.2, gain = 2, zero = 0.02 / 0.3;

double curve(double x) { return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - zero; }

}  // namespace

double filmic(double radiance) { return std::clamp(curve(gain * radiance) / curve(white), 0.0, 1.0); }

// The positive root of the curve's quadratic.
double unfilmic(double shown) {
    const double k = shown * curve(white) + zero;
    const double a = 0.15 * (1 - k), b = 0.05 - 0.5 * k, c = 0.004 - 0.06 * k;
    return (std::sqrt(std::max(b * b - 4 * a * c, 0.0)) - b) / (2 * gain * a);
}

}  // namespace nacre
