// A smooth lobe as a grid of facets.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/lobe.h"

namespace nacre {

// A direction of a span and the solid angle there for one of (t, psi): the cosine of h' and its azimuth,
// which comes as a unit vector.
struct SpanPoint {
    dvec3 h;
    double solid_angle;
};

inline SpanPoint span_point(const LobeParameterization& span, double t, dvec2 azimuth) {
    const double s = std::sqrt(std::max(1 - t * t, 0.0));
    const dvec3 stretched{span.stretch.x * s * azimuth.x, span.stretch.y * s * azimuth.y, t};
    const double length = glm::length(stretched);
    dvec3 h = stretched / length;
    h.z *= span.flip;
    return {h, span.stretch.x * span.stretch.y / (length * length * length)};
}

inline dvec2 unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

// The facet that represents cell (row, column) of side x side cells of a span, of equal solid angle in its
// h'.
inline Facet span_facet(const LobeModel& lobe, const LobeParameterization& span, int side, int row,
                        int column) {
    const SpanPoint at =
        span_point(span, (row + 0.5) / side, unit_vector(2 * std::numbers::pi * (column + 0.5) / side));
    return {at.h, lobe.density(at.h) * at.solid_angle * 2 * std::numbers::pi / side / side};
}

}  // namespace nacre
