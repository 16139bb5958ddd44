#include "core/study/excess_energy.h"

#include <algorithm>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/model/polar_angles.h"

namespace nacre {

ExcessEnergy excess_energy(const Tables& tables, int polar, int azimuths, const std::stop_token& stop) {
    const AlbedoQuadrature rule(*tables.distribution, tables.shading, 0, 1e-4);
    ExcessEnergy excess;
    for (int i = 0; i < polar; ++i)
        for (int j = 0; j < azimuths; ++j) {
            if (stop.stop_requested()) throw BakeCancelled();
            const dvec3 k = polar_direction(90 * (i + 0.5) / polar, 360.0 * j / azimuths);
            const double r = rule(k, tables.distribution->projected_area(k))[0];
            excess.largest = std::max(excess.largest, r);
            if (r > 1) ++excess.directions;
        }
    return excess;
}

}  // namespace nacre
