#include "core/paint/tip.h"

#include <algorithm>
#include <cmath>

#include "core/paint/raster_texels.h"

namespace nacre {

Tip::Tip(const Dab& dab)
    : raster_(*dab.tip),
      radius_(dab.radius()),
      from_pole_(shortest_rotation({0, 0, 1}, dab.at)),
      to_tip_(dab.to_tip) {}

double Tip::operator()(dvec3 h) const {
    const dvec3 l = h * from_pole_;
    const double sine = std::hypot(l.x, l.y);
    const double angle = std::atan2(sine, l.z) / radius_;
    const dvec2 at = sine > 0 ? to_tip_ * dvec2(l.x, l.y) * (angle / sine) : dvec2(0);
    if (std::max(std::abs(at.x), std::abs(at.y)) >= 1) return 0;
    return std::clamp(raster_value(raster_.values, raster_.width, at), 0.0, 1.0);
}

dvec3 Tip::direction(dvec2 at) const {
    const double length = glm::length(at), angle = radius_ * length;
    const dvec2 flat = length > 0 ? glm::transpose(to_tip_) * at * (std::sin(angle) / length) : dvec2(0);
    return from_pole_ * dvec3(flat, std::cos(angle));
}

}  // namespace nacre
