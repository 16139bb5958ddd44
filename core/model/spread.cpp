#include "core/model/spread.h"

#include <algorithm>
#include <cmath>

namespace nacre {

Spread& Spread::operator+=(const Spread& other) {
    xx += other.xx, yy += other.yy, zz += other.zz;
    xy += other.xy, xz += other.xz, yz += other.yz;
    return *this;
}

Spread operator*(double factor, Spread spread) {
    for (double* s : {&spread.xx, &spread.yy, &spread.zz, &spread.xy, &spread.xz, &spread.yz}) *s *= factor;
    return spread;
}

Spread rotated(const Spread& spread, const glm::dmat3& rotation) {
    const glm::dmat3 s{spread.xx, spread.xy, spread.xz, spread.xy, spread.yy,
                       spread.yz, spread.xz, spread.yz, spread.zz};
    const glm::dmat3 r = rotation * s * glm::transpose(rotation);
    return {r[0][0], r[1][1], r[2][2], r[0][1], r[0][2], r[1][2]};
}

double Spread::half_width() const {
    const double trace = xx + yy + zz;
    const double squares = xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz);
    return std::sqrt(0.5 * (trace + std::sqrt(std::max(2 * squares - trace * trace, 0.0))));
}

Spread spread_along(dvec3 u) { return {u.x * u.x, u.y * u.y, u.z * u.z, u.x * u.y, u.x * u.z, u.y * u.z}; }

Spread spread_on_disk(dvec2 at, double reach) {
    at *= std::min(1.0, 1 / std::max(glm::length(at), 1e-30));
    const double s = std::sqrt(2 - glm::dot(at, at));
    Spread spread = spread_along(reach * dvec3(s - at.x * at.x / s, -at.x * at.y / s, -2 * at.x));
    spread += spread_along(reach * dvec3(-at.x * at.y / s, s - at.y * at.y / s, -2 * at.y));
    return spread;
}

}  // namespace nacre
