// A photographer's dark room.
#include "core/light/procedural.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nacre {
namespace {

using glm::dvec3;

// A rectangle of cloth with a lamp behind it, on the plane that touches the unit sphere at `toward`.
struct SoftBox {
    dvec3 toward;
    double half_width, half_height;  // on that plane
    double edge;                     // over which the cloth fades
    double hot;                      // how much brighter its middle is than its rim
    dvec3 radiance;
};

const SoftBox boxes[] = {
    {{-0.60, 0.55, 0.58}, 0.52, 0.40, 0.04, 0.6, {5.2, 5.0, 4.7}},    // the key light
    {{0.92, 0.10, 0.28}, 0.34, 0.85, 0.10, 0.3, {0.85, 0.95, 1.10}},  // a dim one to fill
    {{-0.80, 0.22, -0.56}, 0.09, 0.85, 0.03, 0.2, {5.0, 5.4, 6.0}},   // a strip for the rim
    {{0.10, 0.97, -0.20}, 0.70, 0.26, 0.06, 0.4, {2.1, 2.05, 2.0}}};  // one above

double smooth(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

dvec3 light_of(const SoftBox& box, dvec3 d) {
    const dvec3 toward = glm::normalize(box.toward);
    const double along = glm::dot(d, toward);
    if (along <= 0) return dvec3{0};
    const dvec3 right = glm::normalize(glm::cross(dvec3{0, 1, 0}, toward));
    const double x = glm::dot(d, right) / along / box.half_width;
    const double y = glm::dot(d, glm::cross(toward, right)) / along / box.half_height;
    const double inside = smooth((1 - std::fabs(x)) * box.half_width / box.edge) *
                          smooth((1 - std::fabs(y)) * box.half_height / box.edge);
    const double middle = 1 - box.hot + box.hot * std::exp(-(x * x + y * y));
    return box.radiance * (inside * middle);
}

// Darker below, a faint glow on the wall behind the object.
dvec3 room(dvec3 d) {
    const double height = 0.5 + 0.5 * d.y;
    const double wall = std::exp(-3 * ((d.y + 0.15) * (d.y + 0.15) + d.x * d.x)) * std::max(-d.z, 0.0);
    return dvec3{0.050, 0.052, 0.058} * (0.4 + height) + dvec3{0.16, 0.165, 0.175} * wall;
}

dvec3 studio_radiance(dvec3 direction) {
    dvec3 sum = room(direction);
    for (const SoftBox& box : boxes) sum += light_of(box, direction);
    return sum;
}

}  // namespace

const ProceduralEnvironment studio_environment{
    .name = "studio",
    .label = "Soft boxes",
    .about = "A photographer's dark room: a large lamp, a dim one, a strip and one above.",
    .width = 1024,
    .picture = [](int width) { return painted_environment(width, studio_radiance); }};

}  // namespace nacre
