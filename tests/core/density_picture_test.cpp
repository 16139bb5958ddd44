#include "core/paint/density_picture.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/model/live_distribution.h"
#include "core/paint/colour_map.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

// Linear luminance of an 8-bit sRGB colour (IEC 61966-2-1).
double luminance(glm::u8vec3 c) {
    const auto linear = [](int byte) {
        const double v = byte / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

glm::u8vec3 texel(const HemispherePicture& picture, int column, int row) {
    const auto at = static_cast<std::size_t>((row * picture.size.x + column) * 4);
    return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
}

}  // namespace

TEST_CASE("colour map: lightness rises evenly from black to pale yellow") {
    // matplotlib's own values at both ends and in the middle.
    const auto near = [](glm::u8vec3 a, glm::dvec3 b) {
        return glm::length(glm::dvec3(a) / 255.0 - b) < 0.035;
    };
    CHECK(near(inferno(0), {0.001462, 0.000466, 0.013866}));
    CHECK(near(inferno(0.5), {0.735683, 0.215906, 0.330245}));
    CHECK(near(inferno(1), {0.988362, 0.998364, 0.644924}));
    double before = -1;
    for (int i = 0; i <= 100; ++i) {
        const double lightness = std::cbrt(luminance(inferno(i / 100.0)));
        CHECK(lightness > before - 0.002);
        before = lightness;
    }
    CHECK(inferno(-1) == inferno(0));
    CHECK(inferno(2) == inferno(1));
}

TEST_CASE("density scale: positions and values are each other's inverse") {
    for (const ScaleKind kind : {ScaleKind::perceptual, ScaleKind::linear, ScaleKind::logarithmic}) {
        const DensityScale scale{.peak = 7, .kind = kind};
        for (const double t : {0.03, 0.1, 0.5, 1.0})
            CHECK(scale.position(scale.value(t)) == doctest::Approx(t));
        CHECK(scale.position(0) == 0);
        CHECK(scale.position(1e9) == 1);
        CHECK(scale.position(std::nan("")) == 0);
    }
    // A grey of 18 % has the lightness 49.5 (CIE 15:2004).
    CHECK(DensityScale{}.position(0.18) == doctest::Approx(0.495).epsilon(1e-3));
}

TEST_CASE("density picture: brightest at the lobe's axis, transparent beside the disk") {
    const Design design = test::design_of(GaussianLobe{0.1, 0.1}, 40, 90);
    const FacetDistribution p(design.distribution);
    const dvec3 axis = layer_frame(design.distribution.layers[0])[2];
    const HemisphereView view({.highlight = false}, {200, 200});
    const double peak = peak_density(p);
    CHECK(peak == doctest::Approx(p.density(axis)));
    const HemispherePicture picture = density_picture(&p, view, {.peak = peak, .kind = ScaleKind::linear}, 1);
    REQUIRE(picture.size == glm::ivec2(200, 200));
    REQUIRE(picture.rgba.size() == 200 * 200 * 4);
    CHECK(picture.rgba[3] == 0);
    const glm::dvec2 at = view.pixel(axis);
    CHECK(at.y < 100);
    CHECK(luminance(texel(picture, int(at.x), int(at.y))) > 0.6);
    CHECK(luminance(texel(picture, 100, 150)) < 0.01);
    const HemispherePicture wide =
        density_picture(&p, view, {.peak = peak, .kind = ScaleKind::logarithmic}, 1);
    CHECK(luminance(texel(wide, int(at.x), int(at.y) - 10)) >
          luminance(texel(picture, int(at.x), int(at.y) - 10)));
    CHECK(density_picture(&p, view, {.peak = peak, .kind = ScaleKind::linear}, 3).size == glm::ivec2(67, 67));
}

TEST_CASE("live distribution: after each edit it is what is made anew") {
    Distribution design = test::design_of(GaussianLobe{0.2, 0.1}).distribution;
    Layer painted;
    painted.lobe = PaintedLobe{test::picture_of(256, [](double x, double y) { return x * x + y * y; })};
    design.layers.push_back(painted);
    LiveDistribution live;
    Random random(3);
    const auto agrees = [&] {
        const auto p = live.of(design);
        REQUIRE(p);
        const FacetDistribution fresh(design);
        CHECK(p->mean() == fresh.mean());
        for (int i = 0; i < 50; ++i) {
            const dvec3 h = test::random_direction(random);
            CHECK(p->density(h) == fresh.density(h));
            CHECK(p->area(h).g == fresh.area(h).g);
        }
    };
    agrees();
    const int revision = live.revision();
    live.of(design);
    CHECK(live.revision() == revision);
    auto touched = std::make_shared<Raster>(*std::get<PaintedLobe>(design.layers[1].lobe).image.raster);
    for (std::size_t i = 20000; i < 20040; ++i) touched->values[i] += 3;
    design.layers[1].lobe = PaintedLobe{{{}, touched}};
    agrees();
    CHECK(live.revision() == revision + 1);
    std::swap(design.layers[0], design.layers[1]);
    agrees();
    design.layers[1].tilt = 30;
    agrees();
    for (Layer& layer : design.layers) layer.enabled = false;
    CHECK(live.of(design) == nullptr);
    design.layers[0].enabled = true;
    agrees();
}
