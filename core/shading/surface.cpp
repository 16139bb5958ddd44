#include "core/shading/surface.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/model/disk_texels.h"

namespace nacre {
namespace {

using Shader = Shading<double>;

int append(std::vector<float>& data, const std::vector<float>& values) {
    const int offset = static_cast<int>(data.size());
    data.insert(data.end(), values.begin(), values.end());
    return offset;
}

// 1 - s + s u texel = f (1 - s' + s' texel) with f = 1 - s + s u and s' = s u/f.
void describe_modulation(const Modulation& modulation, Shader::Layer& layer, std::vector<float>& data) {
    const ScaledPicture picture = scaled_picture(*modulation.image.raster);
    const double weighted = modulation.strength * picture.unit;
    const double factor = 1 - modulation.strength + weighted;
    layer.picture_offset = append(data, picture.texels);
    layer.picture_size = modulation.image.raster->width;
    layer.picture_strength = picture.unit == 1 ? modulation.strength : weighted / factor;
    if (picture.unit != 1) layer.scale *= factor;
}

// In a medium of index `above`.
void describe_fresnel(const Fresnel& fresnel, double above, Shader& shading) {
    shading.kinds.fresnel = static_cast<int>(fresnel.index());
    const ShaderFresnel numbers = shader_beneath(fresnel, above);
    shading.surface.fresnel_a = numbers.a;
    shading.surface.fresnel_b = numbers.b;
    shading.fresnel_curve = numbers.curve;
    if (!numbers.curve) return;
    shading.curve = numbers.curve->values.data();
    shading.surface.fresnel_a = {0, numbers.curve->nodes, 0};
}

// The bake reads them before the layers are described whole.
void describe_tints(const Distribution& distribution, const FacetDistribution& facets, Shader& shading) {
    shading.kinds.tint = tint_of(distribution);
    if (shading.kinds.tint == Tint::none) return;
    shading.layer_count = static_cast<int>(facets.lobes().size());
    for (std::size_t i = 0; i < facets.lobes().size(); ++i)
        shading.layers[i].tint = distribution.layers[facets.lobes()[i].layer].tint;
}

}  // namespace

void describe_layers(const Distribution& distribution, const FacetDistribution& facets,
                     Shading<double>& shading, std::vector<float>& data) {
    shading.layer_count = 0;
    for (const PlacedLobe& placed : facets.lobes()) {
        const Layer& layer = distribution.layers[placed.layer];
        Shader::Layer& out = shading.layers[shading.layer_count++];
        const ShaderLobe lobe = std::visit([](const auto& kind) { return kind.shader(); }, layer.lobe);
        out = {};
        out.kind = static_cast<int>(layer.lobe.index());
        out.inverse_width = lobe.inverse_width;
        out.scale = placed.scale * lobe.unit;
        out.axis_x = placed.frame[0];
        out.axis_y = placed.frame[1];
        out.axis_z = placed.frame[2];
        out.tint = layer.tint;
        out.data_size = lobe.data_size;
        if (!lobe.data.empty()) out.data_offset = append(data, lobe.data);
        if (layer.modulation) describe_modulation(*layer.modulation, out, data);
    }
}

void append_fresnel_curve(Shading<double>& shading, std::vector<float>& data) {
    if (shading.fresnel_curve) shading.surface.fresnel_a.x = append(data, shading.fresnel_curve->values);
}

void describe_material(const Design& design, const FacetDistribution& facets, Shading<double>& shading) {
    shading.kinds.masking = static_cast<int>(design.shadowing.model.index());
    shading.kinds.diffuse = static_cast<int>(design.diffuse.index());
    shading.kinds.clamp = design.shadowing.clamp;
    Shader::Surface& surface = shading.surface;
    surface.N = facets.mean_cosine() * design.distribution.mean_cosine_scale;
    const double width =
        std::visit([](const auto& model) { return model.shader_width(); }, design.shadowing.model);
    surface.masking_width = width * (std::numbers::pi / 180);
    describe_fresnel(design.fresnel, index_above(design.coat), shading);
    describe_tints(design.distribution, facets, shading);
    const dvec3 f0 = shading.fresnel(1) * mean_tint(design.distribution);
    const ShaderDiffuse diffuse =
        std::visit([&](const auto& model) { return model.shader(f0); }, design.diffuse);
    surface.albedo = diffuse.albedo;
    surface.kd = diffuse.kd;
    surface.ks = diffuse.ks * design.specular.intensity;
    surface.retro = design.retro.weight;
    shading.kinds.retro = design.retro.weight > 0;
}

Reflectance reflectance_of(const Fresnel& fresnel) {
    Shader shading;
    describe_fresnel(fresnel, 1, shading);
    return [shading](double cosine) { return shading.fresnel(cosine); };
}

dvec3 normal_reflectance(const Fresnel& fresnel) { return reflectance_of(fresnel)(1); }

}  // namespace nacre
