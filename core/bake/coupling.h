// Integrals of R over the hemisphere, of the very interpolant that rendering reads, so that a white furnace
// closes (Ashikhmin 2000, eq. 28).
#pragma once

#include "core/bake/workers.h"
#include "core/model/shading.h"

namespace nacre {

struct AlbedoIntegrals {
    // (1/pi) integral of R cos dk, F = 1, for each colour; a tint that all layers share is left out
    glm::dvec3 mean{0};
    glm::dvec3 coupling{
        0};  // c = 1/integral of (whole - R)+ cos dk for each colour, 1/sr; 0 where nothing is left
};

// `shading` holds finished albedo tables; whole is 1, or f0 for the paper's metal. `tolerance`: absolute, of
// what lies between two rows of R. Throws BakeCancelled.
AlbedoIntegrals integrate_albedo(const Shading<double>& shading, double tolerance, Workers& workers);

}  // namespace nacre
