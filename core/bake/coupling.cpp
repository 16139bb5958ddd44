#include "core/bake/coupling.h"

#include <numbers>

#include "core/bake/table_integral.h"

namespace nacre {
namespace {

using std::numbers::pi;

// Below this part of pi nothing is left for the diffuse term; 1/integral would only blow up rounding.
constexpr double nothing_left = 1e-9;

}  // namespace

AlbedoIntegrals integrate_albedo(const Shading<double>& shading, double tolerance, Workers& workers) {
    const Values<6> sum = integrate_tables<6>(
        shading, tolerance, workers,
        [&](const WeightedDirections& directions) { return sum_shares(shading, directions); });
    AlbedoIntegrals result;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        result.mean[i] = sum[at] / pi;
        const double rest = sum[3 + at];
        result.coupling[i] = rest > nothing_left * pi ? 1 / rest : 0;
    }
    return result;
}

}  // namespace nacre
