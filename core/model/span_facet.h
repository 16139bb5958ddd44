// A smooth lobe as a grid of facets.
#pragma once

#include <cmath>
#include <numbers>

#include "core/model/lobe.h"

namespace nacre {

// The facet that stands for cell (row, column) of side x side cells of a span, of equal solid angle in its
// h'.
inline Facet span_facet(const LobeModel& lobe, const LobeSpan& span, int side, int row, int column) {
    const double patch = 2 * std::numbers::pi / side / side * span.stretch.x * span.stretch.y;
    const double t = (row + 0.5) / side, s = std::sqrt(1 - t * t);
    const double psi = 2 * std::numbers::pi * (column + 0.5) / side;
    const dvec3 stretched{span.stretch.x * s * std::cos(psi), span.stretch.y * s * std::sin(psi), t};
    const double length = glm::length(stretched);
    dvec3 h = stretched / length;
    h.z *= span.flip;
    return {h, lobe.density(h) * patch / (length * length * length)};
}

}  // namespace nacre
