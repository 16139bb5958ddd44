// Lobes that hold a picture: painted ones, and any other lobe multiplied by one.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

// What each texel of a painted lobe's raster, row by row, contributes at a value of 1, in the lobe's frame:
// the facets' mass and their mean direction, which is shorter than 1. Nothing for texels off the disk.
std::vector<Facet> texel_facets(const Raster& raster, const std::optional<Modulation>& modulation);

// Texels a side of the pictures that a painted lobe is bilinear between; none of any other lobe.
std::vector<int> picture_sides(const LobeModel& lobe);

// A painted lobe after a brush has touched its raster: bit-identical to PaintedLobe::modulated_model(), at
// the cost of the dab. Null where `before` is not the painted lobe of a raster of the same size with the same
// modulation.
std::shared_ptr<const LobeModel> repaint(const LobeModel& before, const Layer& after);

// The facets that a brush has added between two such lobes, in the lobe's frame; mass is what was added, of
// either sign. That each represents a small patch, which the lobe's g knows, is left out. Nothing where
// the lobes are no such pair.
std::optional<std::vector<Facet>> painted_between(const LobeModel& before, const LobeModel& after);

// `base` has spans(), so it is any lobe but a painted one.
std::shared_ptr<const LobeModel> make_modulated_lobe(std::shared_ptr<const LobeModel> base,
                                                     const Modulation& modulation, Fineness fineness);

}  // namespace nacre
