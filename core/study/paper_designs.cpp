#include "core/study/paper_designs.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/image/area_average.h"
#include "core/paint/stamps.h"

namespace nacre {
namespace {

constexpr glm::dvec3 gold{1.0, 0.71, 0.29}, aluminium{0.91, 0.92, 0.92};  // Hoffman 2012, table 1
constexpr glm::dvec3 dielectric{0.05};                                    // sec. 6: "set to 5 %"

Layer layer_of(Lobe lobe, double weight = 1, double tilt = 0, double azimuth = 0) {
    Layer layer;
    layer.lobe = std::move(lobe);
    layer.weight = weight;
    layer.tilt = tilt;
    layer.azimuth = azimuth;
    return layer;
}

Design of_layers(std::vector<Layer> layers, Fresnel fresnel, Diffuse diffuse) {
    Design design;
    design.distribution.layers = std::move(layers);
    design.fresnel = std::move(fresnel);
    design.diffuse = diffuse;
    return design;
}

// The picture at about half its size, black around it.
std::shared_ptr<const Raster> in_the_middle(const Raster& picture) {
    const Raster small = area_average(picture, picture.width / 2);
    auto whole = std::make_shared<Raster>();
    whole->width = whole->height = picture.width;
    whole->values.resize(picture.values.size());
    const int first = picture.width / 4;
    for (int row = 0; row < small.height; ++row)
        std::copy_n(small.values.begin() + std::ptrdiff_t{row} * small.width, small.width,
                    whole->values.begin() + std::ptrdiff_t{first + row} * whole->width + first);
    return whole;
}

}  // namespace

Design paper_gaussian(double sigma_x, double sigma_y) {
    return of_layers({layer_of(GaussianLobe{sigma_x, sigma_y})}, NoFresnel{}, NoDiffuse{});
}

Design paper_golden() {
    return of_layers({layer_of(GaussianLobe{0.1, 1})}, SchlickFresnel{gold}, MetalDiffuse{});
}

glm::dvec3 gold_paint() { return {0.72, 0.43, 0.08}; }

Design paper_painted_plastic() {
    return of_layers({layer_of(GaussianLobe{0.1, 0.2})}, SchlickFresnel{dielectric},
                     CoupledDiffuse{gold_paint()});
}

Design paper_grooves(double azimuth) {
    constexpr double tilt = 20;
    const GaussianLobe side{0.1, 0.1};
    return of_layers({layer_of(side, 1, tilt, azimuth), layer_of(side, 1, tilt, azimuth - 180)},
                     SchlickFresnel{aluminium}, MetalDiffuse{});
}

Design paper_satin(const glm::dvec3& albedo) {
    return of_layers({layer_of(GaussianLobe{0.1, limits::infinity}, 0.7),
                      layer_of(GaussianLobe{0.3, limits::infinity}, 0.3)},
                     SchlickFresnel{dielectric}, CoupledDiffuse{albedo});
}

Design paper_velvet(const glm::dvec3& albedo) {
    Design design =
        of_layers({layer_of(InverseGaussianLobe{0.5})}, SchlickFresnel{dielectric}, CoupledDiffuse{albedo});
    design.shadowing.model = CorrelatedMasking{15};
    return design;
}

Design paper_slanted_velvet(const glm::dvec3& albedo) {
    Design design = of_layers({layer_of(GaussianLobe{0.5, limits::infinity}, 1, slanted_lean)},
                              SchlickFresnel{dielectric}, CoupledDiffuse{albedo});
    design.distribution.mean_cosine_scale = 2;
    design.shadowing = {CorrelatedMasking{15}, false};
    return design;
}

Design slanted_mirrors(const SlantedMirrors& how) {
    Design design = paper_slanted_velvet(glm::dvec3{0});
    design.distribution.layers.front().tilt = how.lean;
    design.distribution.mean_cosine_scale = how.mean_cosine_scale;
    design.shadowing.clamp = how.clamp;
    design.fresnel = NoFresnel{};
    design.diffuse = NoDiffuse{};
    return design;
}

Design paper_unusual(const char* stamp, const glm::dvec3& f0) {
    for (const NamedStamp& known : built_in_stamps()) {
        if (known.name != stamp) continue;
        Layer layer = layer_of(GaussianLobe{0.9, 0.9});
        // A sphere shows p upside down.
        layer.rotation = 180;
        layer.modulation = Modulation{{{}, in_the_middle(*known.picture)}, 1};
        return of_layers({std::move(layer)}, SchlickFresnel{f0}, MetalDiffuse{});
    }
    throw std::logic_error("no stamp of that name");
}

}  // namespace nacre
