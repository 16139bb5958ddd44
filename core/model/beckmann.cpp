#include "core/model/beckmann.h"

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr double sqrt_pi = 1.7724538509055160273;

// Visible slopes across k's azimuth have the density (x + v)+ exp(-x^2); below v = -1.5 the exponential
// falls faster than the root finder likes, and y = x + v >= 0 is drawn by rejection instead.
double sample_slope_from_behind(double v, Random& random) {
    for (;;) {
        const double y =
            -(std::log1p(-uniform_random(random)) + std::log1p(-uniform_random(random))) / (-2 * v);
        if (uniform_random(random) < std::exp(-y * y)) return y - v;
    }
}

// Inverts C(x) = (exp(-v^2) - exp(-x^2))/2 + v sqrt(pi)/2 (erf x + erf v) by safeguarded Newton steps.
double sample_slope(double v, Random& random) {
    if (v < -1.5) return sample_slope_from_behind(v, random);
    const double start = 0.5 * std::exp(-v * v) + 0.5 * sqrt_pi * v * std::erf(v);
    const double total = start + 0.5 * sqrt_pi * v;
    const double target = uniform_random(random) * total;
    double low = std::fmax(-v, -6.5), high = 6.5;
    double x = std::fmax(low, 0.0);
    for (int i = 0; i < 100 && high - low > 1e-13; ++i) {
        const double e = std::exp(-x * x);
        const double excess = start - 0.5 * e + 0.5 * sqrt_pi * v * std::erf(x) - target;
        (excess > 0 ? high : low) = x;
        const double slope = (x + v) * e;
        const double next = slope > 0 ? x - excess / slope : low;
        x = next > low && next < high ? next : 0.5 * (low + high);
    }
    return x;
}

double normal_slope(Random& random) {
    return std::normal_distribution<double>(0, std::numbers::sqrt2 / 2)(random);
}

}  // namespace

//   g = kz (1 + erf v)/2 + q exp(-v^2)/(2 sqrt(pi)),  q = |(ax kx, ay ky)|,  v = kz/q
// The derivatives of erf and exp cancel, so dg/dkz and dg/dq are the two factors themselves. With kz < 0 the
// two terms nearly cancel; erfc keeps 14 digits as far as exp(-v^2) is a number.
Area beckmann_area(dvec3 k, dvec2 alpha) {
    const dvec2 stretched{alpha.x * k.x, alpha.y * k.y};
    const double q = std::hypot(stretched.x, stretched.y);
    if (q == 0) return k.z > 0 ? Area{k.z, {0, 0, 1}} : Area{};
    const double v = k.z / q;
    const double along = 0.5 * std::erfc(-v);
    const double across = 0.5 / sqrt_pi * std::exp(-v * v);
    const dvec2 t = across / q * stretched;
    return {std::fmax(k.z * along + q * across, 0.0), {alpha.x * t.x, alpha.y * t.y, along}};
}

dvec3 beckmann_sample_visible(dvec3 k, dvec2 alpha, Random& random) {
    const dvec2 stretched{alpha.x * k.x, alpha.y * k.y};
    const double q = std::hypot(stretched.x, stretched.y);
    const double along = q > 0 ? sample_slope(k.z / q, random) : normal_slope(random);
    const double across = normal_slope(random);
    const dvec2 e = q > 0 ? stretched / q : dvec2{1, 0};
    return glm::normalize(
        dvec3{alpha.x * (along * e.x - across * e.y), alpha.y * (along * e.y + across * e.x), 1});
}

}  // namespace nacre
