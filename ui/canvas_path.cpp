#include "ui/canvas_path.h"

#include <cmath>
#include <numbers>

namespace nacre::ui {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

dvec3 polar_direction(double theta, double phi) {
    const double sine = std::sin(theta * degree);
    return {sine * std::cos(phi * degree), sine * std::sin(phi * degree), std::cos(theta * degree)};
}

double polar_angle(dvec3 h) { return std::atan2(std::hypot(h.x, h.y), h.z) / degree; }

double azimuth(dvec3 h) { return h.x == 0 && h.y == 0 ? 0 : std::atan2(h.y, h.x) / degree; }

}  // namespace nacre::ui
