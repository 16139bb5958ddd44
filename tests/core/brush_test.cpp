#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/facet_distribution.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "core/paint/stamps.h"
#include "core/paint/stroke.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

constexpr double radians = std::numbers::pi / 180;

Raster filled(int side, float value) {
    return {side, side,
            std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), value)};
}

float at(const Raster& raster, int row, int column) {
    return raster.values[static_cast<std::size_t>(row * raster.width + column)];
}

dvec3 polar(double theta, double phi) { return test::polar(std::cos(theta * radians), phi * radians); }

StrokeStyle style_of(PaintTool tool, SymmetryKind kind, int turns = 6) {
    StrokeStyle style{.tool = tool,
                      .brush = {.radius = 9, .hardness = 0.3, .flow = 0.7},
                      .symmetry = {kind, turns},
                      .tip = nullptr};
    if (info(tool).needs == ToolNeed::picture) style.tip = built_in_stamps().front().picture;
    return style;
}

Raster stroked(const Raster& before, const StrokeStyle& style, const std::vector<dvec3>& way) {
    Stroke stroke(before, style, way.front());
    for (const dvec3& h : way) stroke.move_to(h);
    return *stroke.raster();
}

// A picture with left and right, up and down and both diagonals alike.
Raster symmetric_picture(int side) {
    Raster raster = filled(side, 0);
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const int a = std::min(i, side - 1 - i), b = std::min(j, side - 1 - j);
            raster.values[static_cast<std::size_t>(i * side + j)] =
                static_cast<float>((a * b * 37 + a + b) % 101) / 100;
        }
    return raster;
}

double largest_difference(const Raster& a, const Raster& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(a.values[i] - b.values[i])));
    return worst;
}

const std::vector<dvec3> crooked_way = {polar(10, 20), polar(35, 50), polar(50, 100), polar(5, 200),
                                        polar(88, 310)};

}  // namespace

TEST_CASE("brush: mirrored strokes are symmetric to the bit") {
    const Raster before = symmetric_picture(256);
    const int n = 256;
    for (const PaintTool tool : paint_tools) {
        if (tool == PaintTool::smear) continue;  // its copies are averaged where they meet
        CAPTURE(info(tool).face.name);
        const Raster x = stroked(before, style_of(tool, SymmetryKind::mirror_x), crooked_way);
        const Raster y = stroked(before, style_of(tool, SymmetryKind::mirror_y), crooked_way);
        const Raster both = stroked(before, style_of(tool, SymmetryKind::mirror_both), crooked_way);
        CHECK(x != before);
        int wrong = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                wrong += at(x, i, j) != at(x, i, n - 1 - j);
                wrong += at(y, i, j) != at(y, n - 1 - i, j);
                wrong += at(both, i, j) != at(both, i, n - 1 - j) || at(both, i, j) != at(both, n - 1 - i, j);
            }
        CHECK(wrong == 0);
    }
}

TEST_CASE("brush: a smear is symmetric but for rounding, quarter turns of paint are to the bit") {
    const Raster before = symmetric_picture(256);
    const Raster smeared = stroked(before, style_of(PaintTool::smear, SymmetryKind::mirror_x), crooked_way);
    const Raster turned =
        stroked(filled(256, 0), style_of(PaintTool::paint, SymmetryKind::turns, 4), crooked_way);
    double worst = 0;
    int wrong = 0;
    for (int i = 0; i < 256; ++i)
        for (int j = 0; j < 256; ++j) {
            worst =
                std::max(worst, std::abs(static_cast<double>(at(smeared, i, j) - at(smeared, i, 255 - j))));
            wrong += at(turned, i, j) != at(turned, 255 - j, i);
        }
    CHECK(smeared != before);
    CHECK(worst < 1e-5);
    CHECK(wrong == 0);
}

TEST_CASE("brush: a dab is round on the hemisphere, also at the rim, and so is each of its copies") {
    const Brush brush{.radius = 12, .hardness = 0.4, .flow = 0.8};
    for (const int turns : {1, 3, 6, 7})
        for (const double theta : {0.0, 20.0, 60.0, 89.0}) {
            const BrushSymmetry symmetry{turns == 1 ? SymmetryKind::none : SymmetryKind::turns, turns};
            const dvec3 middle = polar(theta, 33);
            const Raster raster =
                stroked(filled(256, 0), {PaintTool::paint, brush, symmetry, nullptr}, {middle});
            double worst = 0;
            for (int i = 0; i < 256; ++i)
                for (int j = 0; j < 256; ++j) {
                    const glm::dvec2 point = texel_point(256, i, j);
                    if (!holds_facets(point)) continue;
                    double nearest = 10;
                    for (int t = 0; t < turns; ++t)
                        nearest = std::min(nearest, angle_between(disk_direction(point),
                                                                  polar(theta, 33 + 360.0 * t / turns)));
                    const double expected = brush.flow * brush_falloff(brush, nearest / (12 * radians));
                    worst = std::max(worst, std::abs(expected - static_cast<double>(at(raster, i, j))));
                }
            CHECK(worst < 1e-6);
        }
}

TEST_CASE("brush: a full ring depends on theta alone") {
    for (const PaintTool tool : {PaintTool::paint, PaintTool::smear}) {
        Raster before = filled(256, 0);
        before = stroked(before, {PaintTool::paint, {}, {SymmetryKind::ring, 6}, nullptr}, {polar(30, 10)});
        const Raster raster =
            stroked(before, style_of(tool, SymmetryKind::ring), {polar(25, 10), polar(60, 140)});
        CHECK(raster != before);
        // Texels of the same distance from the middle, as the eight mirror images of one are.
        double worst = 0;
        for (int i = 0; i < 128; ++i)
            for (int j = 0; j < 128; ++j)
                worst =
                    std::max(worst, std::abs(static_cast<double>(at(raster, i, j) - at(raster, 255 - j, i))));
        CHECK(worst < 1e-5);
        // 119^2 + 120^2 is 169^2, nearly: texels along an axis and along a diagonal.
        CHECK(at(raster, 127, 127 - 60) == doctest::Approx(at(raster, 127 - 42, 127 - 42)).epsilon(0.05));
    }
}

TEST_CASE("brush: it does not matter how the way is parted into events") {
    CHECK(rc::check([] {
        const PaintTool tool =
            *rc::gen::elementOf(std::vector(std::begin(paint_tools), std::end(paint_tools)));
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        Random random(seed);
        const Raster before = symmetric_picture(128);
        std::vector<dvec3> coarse, fine;
        coarse.push_back(test::random_direction(random));
        fine.push_back(coarse.front());
        for (int leg = 0; leg < 3; ++leg) {
            const dvec3 a = coarse.back(), b = test::random_direction(random);
            const int parts = 1 + static_cast<int>(20 * uniform_random(random));
            for (int i = 1; i < parts; ++i) {  // points of the great circle from a to b
                const double t = static_cast<double>(i) / parts, angle = angle_between(a, b);
                fine.push_back(glm::normalize((std::sin((1 - t) * angle) * a + std::sin(t * angle) * b)));
            }
            coarse.push_back(b);
            fine.push_back(b);
        }
        const StrokeStyle style = style_of(tool, SymmetryKind::none);
        RC_ASSERT(largest_difference(stroked(before, style, coarse), stroked(before, style, fine)) < 1e-5);
    }));
}

TEST_CASE("brush: whatever is done, values stay finite, not negative and not above what was there") {
    CHECK(rc::check([] {
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        Raster raster = symmetric_picture(64);
        for (int i = 0; i < 6; ++i) {
            const auto pick = [&](int count) { return static_cast<int>(count * uniform_random(random)); };
            StrokeStyle style = style_of(paint_tools[pick(std::size(paint_tools))],
                                         static_cast<SymmetryKind>(pick(6)), 2 + pick(20));
            style.brush = {brush_radius_min + 50 * uniform_random(random), uniform_random(random),
                           uniform_random(random)};
            if (pick(4) == 0) style.brush.hardness = 1;
            dvec3 a = test::random_direction(random), b = test::random_direction(random);
            if (pick(3) == 0) b.z = -b.z;
            if (pick(4) == 0) a = {0, 0, 1};
            raster = stroked(raster, style, {a, b, a});
            for (const float value : raster.values) RC_ASSERT(value >= 0 && value <= 1.0f + 1e-6f);
        }
    }));
}

TEST_CASE("eraser: leaves zeros") {
    StrokeStyle style = style_of(PaintTool::erase, SymmetryKind::none);
    style.brush = {.radius = 10, .hardness = 0.5, .flow = 1};
    Raster raster = stroked(filled(256, 0.8f), style, {polar(30, 0), polar(30, 90)});
    const dvec3 middle = glm::normalize(polar(30, 0) + polar(30, 90));
    int inside = 0;
    visit_texels(256, middle, 3 * radians, [&](std::size_t index, dvec3 h) {
        if (angle_between(h, middle) > 4 * radians) return;
        CHECK(raster.values[index] == 0);
        ++inside;
    });
    CHECK(inside > 20);
    style.brush = {.radius = 60, .hardness = 0.1, .flow = 0.4};
    style.symmetry.kind = SymmetryKind::ring;
    for (int i = 0; i < 8; ++i) raster = stroked(raster, style, crooked_way);
    CHECK(raster_mass(raster) == 0);
}

TEST_CASE("smoothing: an even picture stays even up to the rim, a rough one becomes smoother") {
    const StrokeStyle style = style_of(PaintTool::smooth, SymmetryKind::none);
    const Raster even = stroked(filled(256, 0.5f), style, crooked_way);
    CHECK(largest_difference(even, filled(256, 0.5f)) < 1e-6);
    Raster rough = filled(256, 0);
    for (std::size_t i = 0; i < rough.values.size(); ++i)
        rough.values[i] = static_cast<float>((i * 7919) % 97) / 97;
    const auto unevenness = [](const Raster& raster) {
        double sum = 0;
        for (int i = 120; i < 136; ++i)
            for (int j = 120; j < 136; ++j)
                sum += std::abs(static_cast<double>(at(raster, i, j) - at(raster, i, j + 1)));
        return sum;
    };
    CHECK(unevenness(stroked(rough, style, {polar(2, 0), polar(2, 180)})) < 0.3 * unevenness(rough));
}

TEST_CASE("smear: paint goes where the brush goes") {
    const Raster before =
        stroked(filled(256, 0), style_of(PaintTool::paint, SymmetryKind::none), {polar(20, 0)});
    StrokeStyle style = style_of(PaintTool::smear, SymmetryKind::none);
    style.brush.flow = 1;
    const Raster after = stroked(before, style, {polar(20, 0), polar(45, 40)});
    const auto value = [](const Raster& raster, dvec3 h) {
        return raster_value(raster.values, 256, disk_point(h));
    };
    CHECK(value(before, polar(42, 39)) == 0);
    CHECK(value(after, polar(42, 39)) > 0.3);
}

TEST_CASE("stamp: the picture stands upright and as broad as the brush") {
    // White in its upper right quarter alone.
    Raster tip = filled(8, 0);
    for (int i = 0; i < 4; ++i)
        for (int j = 4; j < 8; ++j) tip.values[static_cast<std::size_t>(i * 8 + j)] = 1;
    const StrokeStyle style{
        PaintTool::stamp, {.radius = 20, .hardness = 0.5, .flow = 1}, {}, std::make_shared<Raster>(tip)};
    const Raster raster = stroked(filled(256, 0), style, {{0, 0, 1}});
    const auto value = [&](double x, double y) {  // degrees off the middle
        return raster_value(raster.values, 256,
                            disk_point(polar(std::hypot(x, y), std::atan2(y, x) / radians)));
    };
    CHECK(value(10, 10) == doctest::Approx(1));
    CHECK(value(10, -10) == 0);
    CHECK(value(-10, 10) == 0);
    CHECK(value(17, 17) > 0.5);
    CHECK(value(21, 10) == 0);
}

TEST_CASE(
    "brush: opacity bounds a whole stroke, however often it goes over a place; spacing thins the dabs") {
    StrokeStyle style = style_of(PaintTool::paint, SymmetryKind::none);
    style.brush = {.radius = 10, .hardness = 1, .flow = 0.5, .opacity = 0.4};
    std::vector<dvec3> back_and_forth;
    for (int i = 0; i < 20; ++i) back_and_forth.push_back(polar(30, i % 2 == 0 ? 0.0 : 60.0));
    const Raster thick = stroked(filled(256, 0.1f), style, back_and_forth);
    const float most = *std::max_element(thick.values.begin(), thick.values.end());
    CHECK(static_cast<double>(most) == doctest::Approx(0.1 + 0.4 * 0.9).epsilon(1e-3));
    style.brush = {.radius = 4, .hardness = 1, .flow = 1, .spacing = 2};
    const Raster dotted = stroked(filled(256, 0), style, {polar(40, 0), polar(40, 90)});
    style.brush.spacing = 0.1;
    const Raster even = stroked(filled(256, 0), style, {polar(40, 0), polar(40, 90)});
    CHECK(raster_mass(dotted) < 0.85 * raster_mass(even));
}
