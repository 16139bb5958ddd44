#include "core/formats/design_features.h"

#include <algorithm>
#include <cmath>

#include "core/bake/symmetry.h"
#include "core/formats/material_json.h"
#include "core/model/facet_distribution.h"

namespace nacre {
namespace {

constexpr double leaning_least = 1e-6;  // the part of <h> in the surface's plane

bool leans(const Distribution& distribution) {
    const dvec3 mean = FacetDistribution(distribution).mean();
    return std::hypot(mean.x, mean.y) > leaning_least;
}

bool is_painted(const Layer& layer) { return counts(layer) && holds_picture(layer); }

}  // namespace

std::span<const FeatureInfo> all_features() {
    static constexpr std::array<FeatureInfo, feature_count> features = {{
        {Feature::specular, "specular", "specular term"},
        {Feature::anisotropic, "anisotropic", "anisotropic p"},
        {Feature::painted, "painted", "painted p"},
        {Feature::leaning, "leaning", "leaning p"},
        {Feature::intensity, "intensity", "specular intensity"},
        {Feature::multibounce, "multibounce", "multiple bounces"},
        {Feature::tint, "tint", "tints of layers"},
        {Feature::coupled, "coupled", "coupled diffuse"},
        {Feature::diffuse, "diffuse", "other diffuse"},
        {Feature::facets, "facets", "matt facets"},
        {Feature::film, "film", "thin films"},
        {Feature::coat, "coat", "clear coat"},
        {Feature::retro, "retro", "retro-reflection"},
        {Feature::correlated, "correlated", "correlated masking"},
    }};
    return features;
}

bool has_feature(const Design& design, Feature feature) {
    const auto& layers = design.distribution.layers;
    switch (feature) {
        case Feature::specular:
            return true;
        case Feature::anisotropic:
            return find_symmetry(design.distribution).symmetry != Symmetry::isotropic;
        case Feature::painted:
            return std::any_of(layers.begin(), layers.end(), is_painted);
        case Feature::leaning:
            return leans(design.distribution);
        case Feature::intensity:
            return has_intensity(design);
        case Feature::multibounce:
            return has_bounces(design.multibounce);
        case Feature::tint:
            return tint_of(design.distribution) != Tint::none;
        case Feature::coupled:
            return std::holds_alternative<CoupledDiffuse>(design.diffuse);
        case Feature::diffuse:
            return !std::holds_alternative<NoDiffuse>(design.diffuse) &&
                   !has_feature(design, Feature::coupled) && !has_feature(design, Feature::facets);
        case Feature::facets:
            return has_matt_facets(design.diffuse);
        case Feature::film:
            return std::holds_alternative<FilmFresnel>(design.fresnel);
        case Feature::coat:
            return is_coated(design.coat);
        case Feature::retro:
            return is_retro(design);
        case Feature::correlated:
            return !std::holds_alternative<UncorrelatedMasking>(design.shadowing.model);
    }
    return false;
}

std::string_view name_of(Holding holding) {
    switch (holding) {
        case Holding::exact:
            return "exact";
        case Holding::fitted:
            return "fitted";
        case Holding::refused:
            return "refused";
    }
    return {};
}

}  // namespace nacre
