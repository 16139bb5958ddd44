// The fields of the shader's parameters, each with its name in GLSL, in the order of
// shaders/shared/parameters.glsl: for uploading them and for writing them out.
#pragma once

#include "core/model/shading.h"

namespace nacre {

template <class Visit>
void visit_fields(const Shading<double>::Layer& layer, const Visit& visit) {
    visit("kind", layer.kind);
    visit("scale", layer.scale);
    visit("axis_x", layer.axis_x);
    visit("axis_y", layer.axis_y);
    visit("axis_z", layer.axis_z);
    visit("inverse_width", layer.inverse_width);
    visit("data_offset", layer.data_offset);
    visit("data_size", layer.data_size);
    visit("picture_offset", layer.picture_offset);
    visit("picture_size", layer.picture_size);
    visit("picture_strength", layer.picture_strength);
}

template <class Visit>
void visit_fields(const Shading<double>::TableShape& shape, const Visit& visit) {
    visit("g_normal", shape.g_normal);
    visit("axis", shape.axis);
    visit("stretch", shape.stretch);
    visit("lean", shape.lean);
    visit("symmetry", shape.symmetry);
    visit("nodes_w", shape.nodes_w);
    visit("nodes_v", shape.nodes_v);
    visit("nodes_psi", shape.nodes_psi);
    visit("nodes_rho", shape.nodes_rho);
    visit("area_offset", shape.area_offset);
    visit("albedo_offset", shape.albedo_offset);
    visit("residual_offset", shape.residual_offset);
}

// Without `tables`, which comes first.
template <class Visit>
void visit_fields(const Shading<double>::Surface& surface, const Visit& visit) {
    visit("N", surface.N);
    visit("correlation", surface.correlation);
    visit("f0", surface.f0);
    visit("eta", surface.eta);
    visit("kappa", surface.kappa);
    visit("kd", surface.kd);
    visit("ks", surface.ks);
    visit("albedo", surface.albedo);
    visit("coupling", surface.coupling);
}

}  // namespace nacre
