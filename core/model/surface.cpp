#include "core/model/surface.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/model/disk_texels.h"
#include "core/model/isotropic_lobe.h"

namespace nacre {
namespace {

using Shader = Shading<double>;

struct LobeShape {
    int kind;
    dvec2 inverse_width{0};
};

LobeShape shape_of(const Lobe& lobe) {
    if (const auto* l = std::get_if<GaussianLobe>(&lobe))
        return {Shader::LOBE_GAUSSIAN, {1 / l->sigma_x, 1 / l->sigma_y}};
    if (const auto* l = std::get_if<InverseGaussianLobe>(&lobe))
        return {Shader::LOBE_INVERSE_GAUSSIAN, dvec2{1 / l->sigma}};
    if (const auto* l = std::get_if<GgxLobe>(&lobe))
        return {Shader::LOBE_GGX, {1 / l->alpha_x, 1 / l->alpha_y}};
    if (const auto* l = std::get_if<BeckmannLobe>(&lobe))
        return {Shader::LOBE_BECKMANN, {1 / l->alpha_x, 1 / l->alpha_y}};
    if (const auto* l = std::get_if<UniformLobe>(&lobe))
        return {l->domain == UniformDomain::sphere ? Shader::LOBE_SPHERE : Shader::LOBE_HEMISPHERE};
    if (std::holds_alternative<CurveLobe>(lobe)) return {Shader::LOBE_CURVE};
    return {Shader::LOBE_PAINTED};
}

int append(std::vector<float>& data, const std::vector<float>& values) {
    const int offset = static_cast<int>(data.size());
    data.insert(data.end(), values.begin(), values.end());
    return offset;
}

// A picture's texels as they are read, over a power of two that brings the brightest into [1, 2): the digits
// stay, and neither the texels nor a layer's scale leave a float's range whatever unit the picture is in.
struct BroughtNearOne {
    std::vector<float> texels;
    double unit;  // picture = unit * texels
};

BroughtNearOne brought_near_one(const Raster& raster) {
    std::vector<float> texels = extended_past_rim(raster).values;
    const float largest = largest_on_disk(raster);
    if (!(largest > 0)) return {std::move(texels), 1};
    const int exponent = std::ilogb(largest);
    BroughtNearOne result{std::move(texels), std::scalbn(1.0, exponent)};
    for (float& texel : result.texels) texel = std::scalbn(texel, -exponent);
    return result;
}

void describe_painted(const Raster& raster, Shader::Layer& layer, std::vector<float>& data) {
    const BroughtNearOne picture = brought_near_one(raster);
    layer.data_offset = append(data, picture.texels);
    layer.data_size = raster.width;
    layer.scale *= picture.unit;
}

// 1 - s + s u texel = f (1 - s' + s' texel) with f = 1 - s + s u and s' = s u/f.
void describe_modulation(const Modulation& modulation, Shader::Layer& layer, std::vector<float>& data) {
    const BroughtNearOne picture = brought_near_one(*modulation.image.raster);
    const double weighted = modulation.strength * picture.unit;
    const double factor = 1 - modulation.strength + weighted;
    layer.picture_offset = append(data, picture.texels);
    layer.picture_size = modulation.image.raster->width;
    layer.picture_strength = picture.unit == 1 ? modulation.strength : weighted / factor;
    if (picture.unit != 1) layer.scale *= factor;
}

}  // namespace

void describe_layers(const Distribution& distribution, const FacetDistribution& facets,
                     Shading<double>& shading, std::vector<float>& data) {
    shading.layer_count = 0;
    for (const PlacedLobe& placed : facets.lobes()) {
        const Layer& layer = distribution.layers[placed.layer];
        Shader::Layer& out = shading.layers[shading.layer_count++];
        const LobeShape shape = shape_of(layer.lobe);
        out = {};
        out.kind = shape.kind;
        out.inverse_width = shape.inverse_width;
        out.scale = placed.scale;
        out.axis_x = placed.frame[0];
        out.axis_y = placed.frame[1];
        out.axis_z = placed.frame[2];
        if (const auto* curve = std::get_if<CurveLobe>(&layer.lobe)) {
            out.data_offset = append(data, curve_data(*curve));
            out.data_size = static_cast<int>(curve->points.size());
        }
        if (const auto* painted = std::get_if<PaintedLobe>(&layer.lobe))
            describe_painted(*painted->image.raster, out, data);
        if (layer.modulation) describe_modulation(*layer.modulation, out, data);
    }
}

void describe_material(const Design& design, const FacetDistribution& facets, Shading<double>& shading) {
    shading.kinds.fresnel = kind_of(design.fresnel);
    shading.kinds.visibility = kind_of(design.shadowing.model);
    shading.kinds.diffuse = kind_of(design.diffuse);
    shading.kinds.clamp = design.shadowing.clamp;
    Shader::Surface& surface = shading.surface;
    surface.N = facets.mean_cosine() * design.distribution.mean_cosine_scale;
    surface.correlation = design.shadowing.width * (std::numbers::pi / 180);
    if (const auto* f = std::get_if<SchlickFresnel>(&design.fresnel)) surface.f0 = f->f0;
    if (const auto* f = std::get_if<DielectricFresnel>(&design.fresnel)) surface.eta = dvec3{f->ior};
    if (const auto* f = std::get_if<ConductorFresnel>(&design.fresnel)) {
        surface.eta = f->eta;
        surface.kappa = f->k;
    }
    if (const auto* d = std::get_if<LambertianDiffuse>(&design.diffuse)) {
        surface.kd = d->kd;
        surface.ks = d->ks;
        surface.albedo = d->albedo;
    }
    if (const auto* d = std::get_if<CoupledDiffuse>(&design.diffuse)) surface.albedo = d->albedo;
    if (shading.kinds.diffuse == DiffuseKind::metal) surface.albedo = shading.fresnel(1);
}

FresnelKind kind_of(const Fresnel& fresnel) {
    if (std::holds_alternative<SchlickFresnel>(fresnel)) return FresnelKind::schlick;
    if (std::holds_alternative<DielectricFresnel>(fresnel)) return FresnelKind::dielectric;
    if (std::holds_alternative<ConductorFresnel>(fresnel)) return FresnelKind::conductor;
    return FresnelKind::none;
}

VisibilityKind kind_of(ShadowingModel model) {
    switch (model) {
        case ShadowingModel::correlated:
            return VisibilityKind::correlated;
        case ShadowingModel::smith_correlated:
            return VisibilityKind::smith_correlated;
        case ShadowingModel::uncorrelated:
            break;
    }
    return VisibilityKind::uncorrelated;
}

DiffuseKind kind_of(const Diffuse& diffuse) {
    if (std::holds_alternative<LambertianDiffuse>(diffuse)) return DiffuseKind::lambertian;
    if (std::holds_alternative<CoupledDiffuse>(diffuse)) return DiffuseKind::coupled;
    if (std::holds_alternative<MetalDiffuse>(diffuse)) return DiffuseKind::metal;
    return DiffuseKind::none;
}

}  // namespace nacre
