#include "core/study/bounce_extremes.h"

#include <fmt/core.h>

#include <utility>

#include "core/study/kind_extremes.h"

namespace nacre {
namespace {

Design of(Lobe lobe, double tilt = 0) {
    Design design;
    design.distribution.layers.assign(1, Layer{});
    design.distribution.layers[0].lobe = std::move(lobe);
    design.distribution.layers[0].tilt = tilt;
    return design;
}

Design with_haze(Design design, double weight) {
    Layer haze;
    haze.lobe = UniformLobe{};
    haze.weight = weight;
    design.distribution.layers.push_back(haze);
    return design;
}

Design grooves(double width, double tilt) {
    Design design = of(GaussianLobe{width, width}, tilt);
    design.distribution.layers.push_back(design.distribution.layers[0]);
    design.distribution.layers[1].azimuth = 180;
    return design;
}

Picture one_texel() {
    return picture_of_texels(64, [](int column, int row) { return column == 40 && row == 20 ? 1 : 0; });
}

}  // namespace

void add_bounce_extremes(std::vector<ExtremeCase>& cases) {
    struct Bouncing {
        const char* name;
        Design design;
        bool hard = false;
        double albedo_claim = ExtremeClaims{}.albedo;
    };
    Design tinted = grooves(0.3, 45);
    tinted.distribution.layers[0].tint = {1, 0, 0};
    tinted.distribution.layers[1].tint = {0, 1, 1};
    Design coupled = of(GgxLobe{0.3, 0.3});
    coupled.diffuse = CoupledDiffuse{glm::dvec3{1}};
    const Bouncing designs[] = {{"hemisphere", of(UniformLobe{})},
                                {"brushed", of(GgxLobe{1e-2, 1})},
                                {"grooves of 45 degrees", grooves(0.02, 45)},
                                {"needle", of(GaussianLobe{1e-4, 1e-4})},
                                {"tilted", of(GaussianLobe{0.3, 0.3}, 60), true, 0.2},
                                {"nearly a sphere", with_haze(of(UniformLobe{UniformDomain::sphere}), 0.01)},
                                {"one texel", of(PaintedLobe{one_texel()}), false, 0.02},
                                {"red and cyan grooves", tinted, true, 0.02},
                                {"coupled in white", coupled}};
    for (std::size_t kind = 0; kind < KindSet<Multibounce>::count; ++kind) {
        if (!has_bounces(kind)) continue;
        const Multibounce model = KindSet<Multibounce>::made(kind);
        for (const Bouncing& bouncing : designs) {
            if (is_fitted(model) && !bouncing.hard) continue;
            Design design = bouncing.design;
            design.multibounce = model;
            cases.push_back(
                {"bounces", fmt::format("{}, {}", bouncing.name, KindSet<Multibounce>::names[kind]), design});
            cases.back().albedo_claim = bouncing.albedo_claim;
        }
    }
    for (const Bouncing& bouncing : designs) {
        if (bouncing.design.diffuse != Design{}.diffuse) continue;
        Design design = bouncing.design;
        design.diffuse = FacetDiffuse{.kd = 1, .ks = 0, .albedo = glm::dvec3{1}};
        cases.push_back({"matt facets", fmt::format("matt, {}", bouncing.name), design});
        cases.back().albedo_claim = bouncing.albedo_claim;
    }
}

}  // namespace nacre
