// A sphere of any round BRDF under one distant light, on the processor.
#pragma once

#include <functional>
#include <stop_token>

#include "core/study/paper.h"

namespace nacre {

// rho of unit vectors in the local frame, 1/sr; of a surface without grain, so that any tangent will do.
using RoundBrdf = std::function<double(dvec3 k1, dvec3 k2)>;

// Four points a pixel, light of irradiance pi on what faces it. Throws BakeCancelled soon after a stop.
PaperImage draw_sphere(const PaperTools& tools, const RoundBrdf& brdf, const glm::dvec3& albedo,
                       const PaperView& view);

// Radiance over that of a white Lambertian surface that faces the light, at the point whose normal leans by
// `theta` degrees from the viewer in the plane of the light, positive on its side.
double sphere_radiance(const RoundBrdf& brdf, const PaperView& view, double theta);

}  // namespace nacre
