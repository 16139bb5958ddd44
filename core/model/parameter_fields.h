// The fields of the shader's parameters, each with its name in GLSL, in the order of
// shaders/shared/parameters.glsl: for uploading them, for writing them out and for copying between
// precisions.
#pragma once

#include <type_traits>

#include "core/model/shading.h"

namespace nacre {

// Calls visit(name, field of every one of `layers`) for each field; several of them walk in step.
template <class Visit, class... Layers>
void visit_layer_fields(const Visit& visit, Layers&... layers) {
    visit("kind", layers.kind...);
    visit("scale", layers.scale...);
    visit("axis_x", layers.axis_x...);
    visit("axis_y", layers.axis_y...);
    visit("axis_z", layers.axis_z...);
    visit("inverse_width", layers.inverse_width...);
    visit("data_offset", layers.data_offset...);
    visit("data_size", layers.data_size...);
    visit("picture_offset", layers.picture_offset...);
    visit("picture_size", layers.picture_size...);
    visit("picture_strength", layers.picture_strength...);
    visit("tint", layers.tint...);  // in the GLSL of a tinted design
}

template <class Visit, class... Shapes>
void visit_table_fields(const Visit& visit, Shapes&... shapes) {
    visit("g_normal", shapes.g_normal...);
    visit("moment", shapes.moment...);
    visit("axis", shapes.axis...);
    visit("stretch", shapes.stretch...);
    visit("lean", shapes.lean...);
    visit("symmetry", shapes.symmetry...);
    visit("nodes_w", shapes.nodes_w...);
    visit("nodes_v", shapes.nodes_v...);
    visit("nodes_psi", shapes.nodes_psi...);
    visit("nodes_rho", shapes.nodes_rho...);
    visit("area_offset", shapes.area_offset...);
    visit("albedo_offset", shapes.albedo_offset...);
    visit("residual_offset", shapes.residual_offset...);
    // In the GLSL of a design with multiple bounces.
    visit("row_offset", shapes.row_offset...);
    visit("factor_offset", shapes.factor_offset...);
    visit("spread_offset", shapes.spread_offset...);
    visit("whole_offset", shapes.whole_offset...);
    visit("amplitude_offset", shapes.amplitude_offset...);
    visit("sum_offset", shapes.sum_offset...);
    visit("difference_offset", shapes.difference_offset...);
    visit("momentum_nodes", shapes.momentum_nodes...);
    // In the GLSL of a design with matt facets.
    visit("facet_offset", shapes.facet_offset...);
    visit("facet_nodes", shapes.facet_nodes...);
    visit("facet_rows", shapes.facet_rows...);
    visit("facet_classes", shapes.facet_classes...);
    visit("facet_terms", shapes.facet_terms...);
    // In the GLSL of a coated design.
    visit("coat_offset", shapes.coat_offset...);
    visit("coat_albedo_nodes", shapes.coat_albedo_nodes...);
    visit("coat_nodes", shapes.coat_nodes...);
    visit("coat_rows", shapes.coat_rows...);
}

// Without `tables`, which comes first.
template <class Visit, class... Surfaces>
void visit_surface_fields(const Visit& visit, Surfaces&... surfaces) {
    visit("N", surfaces.N...);
    visit("masking_width", surfaces.masking_width...);
    visit("fresnel_a", surfaces.fresnel_a...);
    visit("fresnel_b", surfaces.fresnel_b...);
    visit("kd", surfaces.kd...);
    visit("ks", surfaces.ks...);
    visit("albedo", surfaces.albedo...);
    visit("coupling", surfaces.coupling...);
    visit("bounce_scale", surfaces.bounce_scale...);
    visit("bounce_mean", surfaces.bounce_mean...);
    visit("bounce_even", surfaces.bounce_even...);
    visit("facet_scale", surfaces.facet_scale...);
    visit("facet_even", surfaces.facet_even...);
    visit("retro", surfaces.retro...);  // in the GLSL of a retro-reflective design
    // In the GLSL of a coated design.
    visit("coat_width", surfaces.coat_width...);
    visit("coat_ior", surfaces.coat_ior...);
    visit("coat_depth", surfaces.coat_depth...);
    visit("coat_even", surfaces.coat_even...);
}

// The surface and its layers from one struct of shading_members.inl to another, whatever their precision.
// Both read the same data.
template <class To, class From>
void copy_surface(To& to, const From& from) {
    to.kinds = from.kinds;
    to.data = from.data;
    to.curve = from.curve;
    const auto copy = [](const char*, auto& field, const auto& value) {
        field = std::remove_reference_t<decltype(field)>(value);
    };
    visit_surface_fields(copy, to.surface, from.surface);
    visit_table_fields(copy, to.surface.tables, from.surface.tables);
    to.layer_count = from.layer_count;
    for (int i = 0; i < from.layer_count; ++i) visit_layer_fields(copy, to.layers[i], from.layers[i]);
}

template <class Visit>
void visit_fields(const Shading<double>::Layer& layer, const Visit& visit) {
    visit_layer_fields(visit, layer);
}

template <class Visit>
void visit_fields(const Shading<double>::TableShape& shape, const Visit& visit) {
    visit_table_fields(visit, shape);
}

template <class Visit>
void visit_fields(const Shading<double>::Surface& surface, const Visit& visit) {
    visit_surface_fields(visit, surface);
}

template <class Visit>
void visit_fields(const Shading<double>::ClosedForm& form, const Visit& visit) {
    visit("model", form.model);
    visit("axis", form.axis);
    visit("width", form.width);
    visit("inverse_width", form.inverse_width);
    visit("scale", form.scale);
    visit("sigma2", form.sigma2);
    visit("rho", form.rho);
    visit("albedo_offset", form.albedo_offset);
}

}  // namespace nacre
