#include "core/paint/painted_layer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/facet_distribution.h"
#include "core/paint/raster_texels.h"
#include "core/paint/shape.h"
#include "core/paint/stamps.h"
#include "core/paint/stroke.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/texel_sums.h"

using namespace nacre;

namespace {

constexpr double radians = std::numbers::pi / 180;

Raster filled(int side, float value) {
    return {side, side,
            std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), value)};
}

dvec3 polar(double theta, double phi) { return test::polar(std::cos(theta * radians), phi * radians); }

StrokeStyle style_of(PaintTool tool, SymmetryKind kind) {
    return {tool, {.radius = 9, .hardness = 0.3, .flow = 0.7}, {kind, 6}, nullptr};
}

}  // namespace

TEST_CASE("shapes: a line on its great circle, a ring at its angle, a star on its rays") {
    const Brush brush{.radius = 4, .hardness = 0.5, .flow = 1};
    const Raster blank = filled(512, 0);
    const auto value = [](const Raster& raster, dvec3 h) {
        return raster_value(raster.values, 512, disk_point(h));
    };
    const auto drawn = [&](PaintTool tool, dvec3 from, dvec3 to, BrushSymmetry symmetry = {}) {
        Stroke stroke(blank, {tool, brush, symmetry, nullptr}, from);
        stroke.move_to({1, 0, 0});  // where it ends counts, not the way there
        stroke.move_to(to);
        return stroke.raster();
    };
    const dvec3 a = polar(40, 10), b = polar(50, 120);
    const auto line = drawn(PaintTool::line, a, b);
    for (const double t : {0.0, 0.3, 0.5, 1.0})
        CHECK(value(*line, glm::normalize((1 - t) * a + t * b)) == doctest::Approx(1));
    CHECK(value(*line, polar(70, 60)) == 0);
    const auto ring = drawn(PaintTool::ring, {0, 0, 1}, polar(35, 0));
    for (double phi = 0; phi < 360; phi += 17) {
        CHECK(value(*ring, polar(35, phi)) == doctest::Approx(1));
        CHECK(value(*ring, polar(41, phi)) == 0);
        CHECK(value(*ring, polar(29, phi)) == 0);
    }
    const auto star = drawn(PaintTool::star, {0, 0, 1}, polar(40, 20));
    for (int ray = 0; ray < 5; ++ray) {
        CHECK(value(*star, polar(30, 20 + 72 * ray)) == doctest::Approx(1));
        CHECK(value(*star, polar(30, 56 + 72 * ray)) == 0);
    }
    CHECK(value(*star, polar(44, 20)) == 0);
    const auto mirrored = drawn(PaintTool::line, a, b, {SymmetryKind::mirror_y, 6});
    CHECK(value(*mirrored, {a.x, -a.y, a.z}) == doctest::Approx(1));
}

TEST_CASE("painted layer: paint adds facets and takes none from elsewhere") {
    Distribution design = test::design_of(GaussianLobe{0.3, 0.3}).distribution;
    design.layers.push_back(blank_painted_layer());
    Layer& layer = design.layers[1];
    CHECK(!layer.enabled);
    const auto paint = [&](PaintTool tool, dvec3 h) {
        const auto& lobe = std::get<PaintedLobe>(layer.lobe);
        Stroke stroke(*paintable(lobe), style_of(tool, SymmetryKind::none), h);
        set_raster(layer, stroke.raster(), raster_mass(*lobe.image.raster),
                   0.5 * weight_of_others(design, 1));
    };
    paint(PaintTool::paint, polar(30, 0));
    CHECK(layer.enabled);
    CHECK(layer.weight == 0.5);
    const FacetDistribution first(design);
    paint(PaintTool::paint, polar(60, 180));
    const FacetDistribution second(design);
    // What was painted and what was there keep their ratio.
    const dvec3 painted = polar(30, 0), there = polar(2, 90);
    CHECK(second.density(painted) / second.density(there) ==
          doctest::Approx(first.density(painted) / first.density(there)).epsilon(1e-6));
    CHECK(second.density(polar(60, 180)) == doctest::Approx(second.density(painted)).epsilon(0.01));
    StrokeStyle all = style_of(PaintTool::erase, SymmetryKind::ring);
    all.brush = {.radius = 60, .hardness = 0.9, .flow = 1};
    Stroke stroke(*std::get<PaintedLobe>(layer.lobe).image.raster, all, {0, 0, 1});
    stroke.move_to({1, 0, 0});
    set_raster(layer, stroke.raster(), raster_mass(*std::get<PaintedLobe>(layer.lobe).image.raster), 1);
    CHECK(!layer.enabled);
    CHECK_NOTHROW(FacetDistribution{design});
}

TEST_CASE(
    "painted layer: a coarser picture is read between its texels, and N, H and g are sums over texels") {
    const PaintedLobe lobe{
        test::picture_of(64, [](double x, double y) { return 0.2 + 0.1 * x + 0.3 * y * y; })};
    const auto finer = paintable(lobe);
    CHECK(finer->width == painted_side);
    CHECK(paintable(PaintedLobe{{{}, finer}}) == finer);
    Random random(5);
    const auto before = make_lobe(test::design_of(lobe).distribution.layers[0]);
    const Design design = test::design_of(PaintedLobe{{{}, finer}});
    for (int i = 0; i < 100; ++i) {
        const dvec3 h = test::random_direction(random);
        if (h.z > 0.1)
            CHECK(raster_value(finer->values, painted_side, disk_point(h)) ==
                  doctest::Approx(before->density(h)).epsilon(1e-3));
    }
    Stroke stroke(*finer, style_of(PaintTool::paint, SymmetryKind::turns), polar(20, 70));
    stroke.move_to(polar(70, 160));
    const Design painted = test::design_of(PaintedLobe{{{}, stroke.raster()}});
    const FacetDistribution p(painted.distribution);
    const dvec3 k = test::random_direction(random);
    const test::TexelSums sums = test::texel_sums(*stroke.raster(), glm::dmat3(1), {k});
    CHECK(glm::length(p.mean() - sums.mean / sums.mass) < test::moment_tolerance);
    CHECK(p.projected_area(k) ==
          doctest::Approx(sums.areas.front() / sums.mass).epsilon(test::area_tolerance));
    CHECK(raster_mass(*stroke.raster()) == doctest::Approx(sums.mass).epsilon(test::moment_tolerance));
}

TEST_CASE("painted layer: a picture in another unit comes to the brush's, and p is the same") {
    for (const double unit : {1e-20, 1e-5, 0.5, 70.0, 1e20}) {
        const PaintedLobe lobe{test::picture_of(512, [&](double x, double y) { return unit * (1 + x * y); })};
        const auto raster = paintable(lobe);
        const float largest = *std::max_element(raster->values.begin(), raster->values.end());
        CHECK(largest > 1e-3f);
        CHECK(largest <= 1);
        const Design before = test::design_of(lobe), after = test::design_of(PaintedLobe{{{}, raster}});
        const FacetDistribution p(before.distribution), q(after.distribution);
        for (const double theta : {5.0, 40.0, 80.0})
            CHECK(q.density(polar(theta, 30)) == doctest::Approx(p.density(polar(theta, 30))).epsilon(1e-6));
    }
}

TEST_CASE("stamps: each has white and black, within a circle or nearly") {
    for (const NamedStamp& stamp : built_in_stamps()) {
        CAPTURE(stamp.name);
        const auto [low, high] =
            std::minmax_element(stamp.picture->values.begin(), stamp.picture->values.end());
        CHECK(*low == 0);
        CHECK(*high == 1);
        CHECK(stamp.picture->width == stamp.picture->height);
    }
}

TEST_CASE("stamps: a thumbnail paints as much as its picture, and a small picture is its own") {
    for (const NamedStamp& stamp : built_in_stamps()) {
        CAPTURE(stamp.name);
        CHECK(stamp.thumbnail->width == thumbnail_side);
        const auto mean = [](const Raster& raster) {
            double sum = 0;
            for (const float value : raster.values) sum += static_cast<double>(value);
            return sum / static_cast<double>(raster.values.size());
        };
        CHECK(mean(*stamp.thumbnail) == doctest::Approx(mean(*stamp.picture)).epsilon(1e-5));
    }
    const auto small = std::make_shared<const Raster>(Raster{2, 2, std::vector<float>(4, 1.0f)});
    CHECK(named_stamp("small", small).thumbnail == small);
}
