// Fills the shader's parameters from a design: the layers of p and the material, not the tables.
#pragma once

#include <vector>

#include "core/design/design.h"
#include "core/model/facet_distribution.h"
#include "core/model/shading.h"

namespace nacre {

// Layers, and the curves and pictures they read, appended to `data`.
void describe_layers(const Distribution& distribution, const FacetDistribution& facets,
                     Shading<double>& shading, std::vector<float>& data);

// Masking, Fresnel and diffuse, of facets beneath the coat if there is one; coupling stays 0 until the albedo
// is known, and the coat is left to core/bake/coat_tables.h.
void describe_material(const Design& design, const FacetDistribution& facets, Shading<double>& shading);

// Appends F to `data`, for the shader, where it is a table; offsets up to 2^24 keep all their digits in a
// float.
void append_fresnel_curve(Shading<double>& shading, std::vector<float>& data);

// F of a model, in air.
Reflectance reflectance_of(const Fresnel& fresnel);

// F(1), each colour.
dvec3 normal_reflectance(const Fresnel& fresnel);

}  // namespace nacre
