#include "core/model/float_shading.h"

namespace nacre {
namespace {

using glm::vec2;
using glm::vec3;

float narrowed(double value) { return static_cast<float>(value); }

Shading<float>::Layer narrowed(const Shading<double>::Layer& layer) {
    return {.kind = layer.kind,
            .scale = narrowed(layer.scale),
            .axis_x = vec3(layer.axis_x),
            .axis_y = vec3(layer.axis_y),
            .axis_z = vec3(layer.axis_z),
            .inverse_width = vec2(layer.inverse_width),
            .data_offset = layer.data_offset,
            .data_size = layer.data_size,
            .picture_offset = layer.picture_offset,
            .picture_size = layer.picture_size,
            .picture_strength = narrowed(layer.picture_strength)};
}

Shading<float>::TableShape narrowed(const Shading<double>::TableShape& shape) {
    return {.moment = vec3(shape.moment),
            .axis = vec2(shape.axis),
            .stretch = vec2(shape.stretch),
            .symmetry = shape.symmetry,
            .nodes_w = shape.nodes_w,
            .nodes_v = shape.nodes_v,
            .nodes_psi = shape.nodes_psi,
            .nodes_rho = shape.nodes_rho,
            .width_offset = shape.width_offset,
            .area_offset = shape.area_offset,
            .albedo_offset = shape.albedo_offset,
            .residual_offset = shape.residual_offset};
}

Shading<float>::Surface narrowed(const Shading<double>::Surface& surface) {
    return {.tables = narrowed(surface.tables),
            .N = narrowed(surface.N),
            .correlation = narrowed(surface.correlation),
            .f0 = vec3(surface.f0),
            .eta = vec3(surface.eta),
            .kappa = vec3(surface.kappa),
            .kd = narrowed(surface.kd),
            .ks = narrowed(surface.ks),
            .albedo = vec3(surface.albedo),
            .coupling = vec3(surface.coupling)};
}

}  // namespace

Shading<float> in_float(const Shading<double>& shading) {
    Shading<float> result;
    result.kinds = shading.kinds;
    result.surface = narrowed(shading.surface);
    for (int i = 0; i < shading.layer_count; ++i) result.layers[i] = narrowed(shading.layers[i]);
    result.layer_count = shading.layer_count;
    result.data = shading.data;
    return result;
}

}  // namespace nacre
