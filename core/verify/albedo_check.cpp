#include "core/verify/albedo_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/verify/close_albedo.h"
#include "core/verify/effort.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double tolerance = 1e-6;       // beyond 1
constexpr double rule_error = 1e-3;      // the bake's own quadrature is closer than this
constexpr double reference_seconds = 6;  // of the processor, for R that is close to 1
constexpr int least_settled = 2;
constexpr double steepest = 89.5;  // degrees: the last ring, in place of grazing itself

dvec3 direction(const AlbedoRings& rings, int index) {
    const double theta = (index / rings.azimuths + 1) * (steepest / rings.polar) * (pi / 180);
    const double phi = 2 * pi * (index % rings.azimuths) / rings.azimuths;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// Of the colour that reflects most.
double largest(const AlbedoValues& values, Tint tint) {
    const AlbedoLayout layout{0, tint};
    return *std::max_element(values.begin(), values.begin() + layout.full());
}

}  // namespace

AlbedoCheck measure_albedo(const Tables& tables, const Reference& reference, std::stop_token stop,
                           const AlbedoRings& rings) {
    const AlbedoQuadrature rule(*tables.distribution, tables.shading, 0, 0.1 * rule_error);
    const int count = rings.polar * rings.azimuths;
    std::vector<double> values(static_cast<std::size_t>(count));
    tbb::parallel_for(0, count, [&](int i) {
        if (stop.stop_requested()) throw BakeCancelled();
        const dvec3 k = direction(rings, i);
        values[static_cast<std::size_t>(i)] =
            largest(rule(k, tables.distribution->projected_area(k)), tables.shading.kinds.tint);
    });
    std::vector<int> close;
    for (int i = 0; i < count; ++i)
        if (std::fabs(values[static_cast<std::size_t>(i)] - 1) < rule_error) close.push_back(i);
    std::stable_sort(close.begin(), close.end(), [&](int a, int b) {
        return values[static_cast<std::size_t>(a)] > values[static_cast<std::size_t>(b)];
    });
    std::optional<CloseAlbedo> albedo;
    if (!close.empty()) albedo.emplace(reference, tolerance);
    const int settled =
        visit_within(reference_seconds, static_cast<int>(close.size()), least_settled, [&](int i) {
            if (stop.stop_requested()) throw BakeCancelled();
            const int index = close[static_cast<std::size_t>(i)];
            values[static_cast<std::size_t>(index)] =
                largest((*albedo)(direction(rings, index), stop), tables.shading.kinds.tint);
        });
    AlbedoCheck check{.directions = count, .unsettled = static_cast<int>(close.size()) - settled};
    for (std::size_t i = static_cast<std::size_t>(settled); i < close.size(); ++i)
        values[static_cast<std::size_t>(close[i])] = 1;
    for (const double value : values) {
        check.worst = worse_error(check.worst, value);
        if (!(value <= 1 + tolerance)) ++check.violations;
    }
    return check;
}

}  // namespace nacre
