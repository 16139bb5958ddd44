// The highlight of a coat's own facets, whatever lies beneath; see shaders/shared/coat.glsl.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/tables.h"
#include "core/bake/workers.h"

namespace nacre {

// R_c, its directional albedo, at even places in the root of the cosine.
inline constexpr int coat_albedo_nodes = 129;

// `shading` holds the coat.
std::vector<float> coat_albedo_table(const Shading<double>& shading, Workers& workers);

// R_c toward a cosine, by a Gauss rule over the slopes of the facets.
double coat_albedo(const Shading<double>& shading, double cosine);

// Its facets, to be drawn; null without a coat.
std::shared_ptr<const FacetDistribution> coat_facets(const Coat& coat);

}  // namespace nacre
