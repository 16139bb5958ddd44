#include "core/measure/albedo_check.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double tolerance = 1e-6;
constexpr double rule_error = 1e-3;  // the bake's own quadrature is closer than this
constexpr double steepest = 89.5;    // degrees: the last ring, in place of grazing itself

dvec3 direction(const AlbedoRings& rings, int index) {
    const double theta = (index / rings.azimuths + 1) * (steepest / rings.polar) * (pi / 180);
    const double phi = 2 * pi * (index % rings.azimuths) / rings.azimuths;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace

AlbedoCheck measure_albedo(const Tables& tables, const Reference& reference, std::stop_token stop,
                           const AlbedoRings& rings) {
    const AlbedoRule rule(*tables.distribution, tables.shading, 0, 0.1 * rule_error);
    const int count = rings.polar * rings.azimuths;
    std::vector<double> values(static_cast<std::size_t>(count));
    tbb::parallel_for(0, count, [&](int i) {
        if (stop.stop_requested()) throw BakeCancelled();
        const dvec3 k = direction(rings, i);
        double value = rule(k, tables.distribution->projected_area(k))[0];
        if (std::fabs(value - 1) < rule_error) value = reference.albedo(k, stop)[0];
        values[static_cast<std::size_t>(i)] = value;
    });
    AlbedoCheck check{.directions = count};
    for (const double value : values) {
        check.worst = worse_error(check.worst, value);
        if (!(value <= 1 + tolerance)) ++check.violations;
    }
    return check;
}

}  // namespace nacre
