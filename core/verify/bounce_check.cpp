#include "core/verify/bounce_check.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/model/quadrature.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr int directions = 24, rings = 10, azimuths = 360;

}  // namespace

// Gauss over the root of the cosine in a few rings, which crowds directions toward the horizon, and the
// trapezoidal rule over azimuth.
BounceCheck measure_bounces(const Tables& tables, std::stop_token stop) {
    Shading<double> white = tables.shading;
    white.surface.bounce_scale = dvec3{1};
    white.kinds.coat = kind_index<Coat, NoCoat>();
    struct End {
        Shading<double>::Direction direction;
        double weight;
    };
    std::vector<End> ends;
    const auto end = [&](dvec3 k) {
        auto a = white.direction(k);
        a.bounce_F = dvec3{1};
        return a;
    };
    for (int ring = 0; ring < rings; ++ring)
        for (const QuadraturePoint& node : gauss_legendre<14>()) {
            // c = t^2: c dc = 2 t^3 dt.
            const double t = (ring + node.x) / rings, c = t * t, sine = std::sqrt((1 - c) * (1 + c));
            const double weight = c * 2 * t * node.weight / rings * (2 * pi / azimuths);
            for (int i = 0; i < azimuths; ++i) {
                const double phi = 2 * pi * (i + 0.3) / azimuths;
                ends.push_back({end({sine * std::cos(phi), sine * std::sin(phi), c}), weight});
            }
        }
    const std::vector<dvec3> probes = probe_directions(directions);
    std::vector<double> errors(probes.size());
    tbb::parallel_for(std::size_t{0}, probes.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const dvec3 k = probes[i];
        const auto a = end(k);
        const auto spot = white.table_spot(k);
        const double whole = white.bounce_whole(white.albedo_spot(k, spot)) * white.clamped_part(k, a.g);
        double sum = 0;
        for (const End& other : ends) sum += white.multibounce(a, other.direction).x * other.weight;
        errors[i] = std::fabs(1 - whole - sum);
    });
    if (stop.stop_requested()) throw BakeCancelled();
    return {summarise(errors).worst, static_cast<int>(probes.size())};
}

}  // namespace nacre
