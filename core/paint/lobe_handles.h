// What can be taken hold of to shape a parametric lobe on the hemisphere, and what pulling does.
#pragma once

#include <optional>
#include <vector>

#include "core/model/layer.h"
#include "core/model/lobe.h"

namespace nacre {

enum class HandleKind {
    axis,     // the lobe's middle: tilt and azimuth
    width_x,  // an end of the outline: its width along x, or along y
    width_y,
    outline  // in between: turns the lobe about its axis, or widens one that is round
};

struct Handle {
    HandleKind kind;
    dvec3 at;  // unit, in the surface's frame
};

// The points that can be taken; those at the ends of an infinite width lie a degree from the lobe's horizon.
std::vector<Handle> handles_of(const Layer& layer);

// Whether the layer has an outline that can be drawn and taken, and its point at t in [0, 1), in the
// surface's frame: where a Gaussian has fallen to 1/e, and the same slopes of every other lobe with widths.
// The outline of a lobe that is only a picture is its horizon.
bool has_outline(const Layer& layer);
dvec3 outline_at(const Layer& layer, double t);

// Which of the parameters an outline's drag turns or widens: a round lobe without a picture looks the same
// however it is turned.
bool outline_turns(const Layer& layer);

// The layer after its handle has been pulled from the normal `from` to `to`. Both are unit vectors; an axis
// or an end follows `to` itself. An end scales both widths by the same factor, or its own alone where
// `alone`. A Gaussian's end pulled to the horizon becomes infinite; an infinite width stays so while the
// other changes.
Layer pulled(const Layer& layer, HandleKind kind, dvec3 from, dvec3 to, bool alone = false);

// The layer with the width of an end times `factor`, and the other one too unless `alone`.
Layer widened(const Layer& layer, HandleKind end, double factor, bool alone);

// What an artist says of a lobe with widths: how soft it is, the geometric mean of its widths as slopes, and
// how stretched, the width along x over that along y. Finite widths alone; nothing of other lobes.
struct LobeShape {
    double softness = 0.2;
    double stretch = 1;
};
std::optional<LobeShape> shape_of(const Lobe& lobe);
// Within the limits of widths; without effect on a lobe that has no shape.
void set_shape(Lobe& lobe, const LobeShape& shape);

// The layer carried along by the shortest rotation from one unit vector to another, as a rigid body.
Layer carried(const Layer& layer, dvec3 from, dvec3 to);

// All layers carried along together by the shortest rotation that brings their mean normal to n.
void straighten(Distribution& distribution, dvec3 mean);

}  // namespace nacre
