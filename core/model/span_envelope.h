// The envelope of a smooth lobe: even over each of many cells of its own coordinates.
#pragma once

#include <functional>
#include <memory>

#include "core/model/lobe_envelope.h"

namespace nacre {

// The bounds of t^2 + (1 - t^2) (stretch.x^2 e.x^2 + stretch.y^2 e.y^2), the square of |A h'|, over a cell
// that does not reach across an axis.
struct StretchBounds {
    double low, high;
};
StretchBounds stretch_bounds(const LobeParameterization& span, const SpanCell& cell);

// The bounds of e.x^2 in such a cell.
struct SquareBounds {
    double low, high;
};
SquareBounds square_bounds(const SpanCell& cell);

// A number that density(h) times span_point()'s solid angle nowhere exceeds in a cell. Cells lie within a
// quadrant.
using CellPeak = std::function<double(const LobeParameterization& span, const SpanCell& cell)>;

// `lobe` is kept as a reference.
std::unique_ptr<const LobeEnvelope> make_span_envelope(const LobeModel& lobe, CellPeak peak);

}  // namespace nacre
