#include "core/study/matt_sphere.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/model/polar_angles.h"

namespace nacre {
namespace {

constexpr double radius_part = 0.42;  // of the picture's shorter side
constexpr double wall = 0.02;         // radiance
constexpr int points = 2;             // along each side of a pixel

// Toward the viewer, of a surface of that normal; view space.
double radiance(const RoundBrdf& brdf, dvec3 n, dvec3 light) {
    if (light.x * n.x + light.y * n.y + light.z * n.z <= 0 || n.z <= 0) return 0;
    const dvec3 side = std::fabs(n.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{1, 0, 0};
    const dvec3 x = glm::normalize(glm::cross(side, n)), y = glm::cross(n, x);
    const dvec3 k1{glm::dot(light, x), glm::dot(light, y), glm::dot(light, n)};
    return std::numbers::pi * brdf(k1, {x.z, y.z, n.z}) * k1.z;
}

}  // namespace

double sphere_radiance(const RoundBrdf& brdf, const PaperView& view, double theta) {
    return radiance(brdf, polar_direction(theta, view.phi), polar_direction(view.theta, view.phi));
}

PaperImage draw_sphere(const PaperTools& tools, const RoundBrdf& brdf, const glm::dvec3& albedo,
                       const PaperView& view) {
    const dvec3 light = polar_direction(view.theta, view.phi);
    const glm::ivec2 size = tools.size;
    const double radius = radius_part * std::min(size.x, size.y), gain = std::exp2(view.exposure);
    PaperImage image{size, std::vector<float>(static_cast<std::size_t>(size.x * size.y * 3))};
    tbb::parallel_for(0, size.y, [&](int row) {
        for (int column = 0; column < size.x; ++column) {
            if (tools.stop.stop_requested()) throw BakeCancelled();
            dvec3 sum{0};
            for (int i = 0; i < points * points; ++i) {
                const double x = (column + (i % points + 0.5) / points - 0.5 * size.x) / radius;
                const double y = (0.5 * size.y - row - (i / points + 0.5) / points) / radius;
                const double rest = 1 - x * x - y * y;
                sum += rest > 0 ? albedo * radiance(brdf, {x, y, std::sqrt(rest)}, light) : dvec3{wall};
            }
            for (int channel = 0; channel < 3; ++channel)
                image.rgb[static_cast<std::size_t>((row * size.x + column) * 3 + channel)] =
                    tools.renderer.shown(gain * sum[channel] / (points * points));
        }
    });
    return image;
}

}  // namespace nacre
