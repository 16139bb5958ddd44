// A clear sky with its sun over grey ground (Preetham, Shirley and Smits 1999).
#include "core/light/sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/light/procedural.h"

namespace nacre {
namespace {

using glm::dvec3;
using std::numbers::pi;

// In units of 20 kcd/m^2, so that a white matt surface that faces the sun shows about as bright as under the
// preview's own light.
constexpr double sky_unit = 20;
constexpr double turbidity = 2.6;
constexpr double sun_radius = 1.0 * pi / 180;  // wider than the sun's quarter of a degree, and as much dimmer
constexpr dvec3 ground_albedo{0.21, 0.19, 0.165};
const dvec3 sun_direction = glm::normalize(dvec3{-0.52, 0.62, 0.58});

// What falls on level ground from the sky without its sun.
dvec3 skylight(const ClearSky& sky) {
    constexpr int side = 64;
    dvec3 sum{0};
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < 2 * side; ++j) {
            const double y = std::sqrt((i + 0.5) / side), level = std::sqrt(1 - y * y);
            const double phi = pi * (j + 0.5) / side;
            sum += sky.radiance({level * std::cos(phi), y, level * std::sin(phi)}) * (pi / (2 * side * side));
        }
    return sum;
}

// How much of each texel the sun's disc covers.
std::vector<float> sun_coverage(const LatLong& picture) {
    constexpr int side = 8;
    const double chord = 2 * std::sin(0.5 * sun_radius), texel = 2 * pi / picture.width;
    const glm::dvec2 size(picture.width, picture.height);
    std::vector<float> coverage(picture.radiance.size(), 0);
    for (std::size_t k = 0; k < coverage.size(); ++k) {
        const glm::dvec2 corner(static_cast<int>(k) % picture.width, static_cast<int>(k) / picture.width);
        const auto away = [&](glm::dvec2 at) {
            return glm::length(lat_long_direction((corner + at) / size) - sun_direction);
        };
        if (away(glm::dvec2(0.5)) > chord + texel) continue;
        int inside = 0;
        for (int i = 0; i < side * side; ++i)
            if (away(glm::dvec2(i % side + 0.5, i / side + 0.5) / static_cast<double>(side)) < chord)
                ++inside;
        coverage[k] = static_cast<float>(inside) / (side * side);
    }
    return coverage;
}

// The disc shines, all of its texels together, as the sun does.
LatLong sky_picture(int width) {
    const ClearSky sky(sun_direction, turbidity);
    const dvec3 ground = ground_albedo / pi * (skylight(sky) + sky.sun_illuminance() * sun_direction.y);
    LatLong picture = painted_environment(width, [&](dvec3 d) {
        const double haze = std::clamp(0.5 - d.y / 0.02, 0.0, 1.0);  // a degree of horizon
        return (sky.radiance(d) * (1 - haze) + ground * haze) / sky_unit;
    });
    const std::vector<float> disc = sun_coverage(picture);
    double covered = 0;
    for (std::size_t i = 0; i < disc.size(); ++i)
        covered += static_cast<double>(disc[i]) * texel_solid_angle(picture, static_cast<int>(i) / width);
    const glm::vec3 sun(sky.sun_illuminance() / (sky_unit * covered));
    for (std::size_t i = 0; i < disc.size(); ++i) picture.radiance[i] += sun * disc[i];
    return picture;
}

}  // namespace

const ProceduralEnvironment sky_environment{
    .name = "sky",
    .label = "Sky and sun",
    .about = "A clear sky with its sun over grey ground (Preetham, Shirley and Smits 1999).",
    .width = 1024,
    .picture = sky_picture};

}  // namespace nacre
