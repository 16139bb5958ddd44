// The surfaces of the paper's figures, with the parameters that it gives.
#pragma once

#include "core/design/design.h"

namespace nacre {

// One Gaussian of eq. 34, F = 1 and nothing diffuse.
Design paper_gaussian(double sigma_x, double sigma_y);

Design paper_golden();           // fig. 5: (0.1, 1), f0 of gold, the diffuse term of a metal
Design paper_painted_plastic();  // fig. 7: (0.1, 0.2), f0 = 0.05, coupled diffuse term of gold paint
glm::dvec3 gold_paint();         // the albedo of the latter

// Sec. 6.2: two Gaussians of 0.1 whose normals are 40 degrees apart; `azimuth` is across the grooves.
Design paper_grooves(double azimuth);

Design paper_satin(const glm::dvec3& albedo);   // sec. 6.3
Design paper_velvet(const glm::dvec3& albedo);  // sec. 6.4: eq. 35 of 0.5 with the shadowing of eq. 14

// Sec. 6.4: a cylinder of 0.5, N doubled, in the paper's own form. Bundles slanted by 40 degrees from the
// normal have sides whose normals lean by 50; with 40 in its place the paper's count of directions with R > 1
// does not come out.
inline constexpr double slanted_lean = 50;
Design paper_slanted_velvet(const glm::dvec3& albedo);

// The same of perfect mirrors and nothing diffuse; the paper's has N times 2 and no clamp.
struct SlantedMirrors {
    double lean = slanted_lean;
    double mean_cosine_scale = 2;
    bool clamp = false;
};
Design slanted_mirrors(const SlantedMirrors& how);

// Sec. 6.5: a Gaussian multiplied by one of the built-in stamps at half its size, upright on a sphere.
Design paper_unusual(const char* stamp, const glm::dvec3& f0);

}  // namespace nacre
