// The layer that a brush works on.
#pragma once

#include "core/model/disk_texels.h"
#include "core/model/layer.h"
#include "core/model/lobe.h"

namespace nacre {

// A raster to paint on, with nothing painted yet.
std::shared_ptr<const Raster> blank_raster();

// A layer of it; left out of p until something is painted, since it holds no facets.
Layer blank_painted_layer();

// The raster of a painted layer as a brush needs it: held in the design, and with at least
// painted_side texels a side; a coarser one is read between its texels. Full paint is 1: a picture in another
// unit is brought to a largest value of 1, which changes nothing of p.
std::shared_ptr<const Raster> paintable(const PaintedLobe& lobe);
std::shared_ptr<const Raster> paintable(const std::shared_ptr<const Raster>& picture);

// What of the picture becomes a 1 there.
double paint_unit(const Raster& picture);

// The same direction, or the nearest on the horizon for one below it.
dvec3 above_horizon(dvec3 h);

// Gives the layer another raster, and a weight such that a value of the raster means as
// many facets as before: paint adds facets and removes none elsewhere in the layer. `mass` is raster_mass()
// of the raster that it has; the first paint of a blank layer gets `first_weight`. A layer is enabled by its
// first paint, and left out when the last is erased. It is no longer what a picture made.
void set_raster(Layer& layer, std::shared_ptr<const Raster> raster, double mass, double first_weight);

// That weight, for a layer whose paint goes from one mass to another.
void weigh_by_paint(Layer& layer, double mass, double after, double first_weight);

// Takes all weights by one factor, which changes nothing of p, where the weight of a layer of that mass could
// else outgrow limits::weight_max while all of it is painted over, up to the largest mass there can be.
void make_room_for_paint(Distribution& distribution, std::size_t layer, double mass, double mass_max);

// Of the layers that count, but for the one at `except`.
double weight_of_others(const Distribution& distribution, std::size_t except);

}  // namespace nacre
