// What a press covers at once: areas, gradients, and all of them within a selection.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "core/paint/stroke.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr int side = 256;

Raster blank() { return {side, side, std::vector<float>(std::size_t{side} * side)}; }

dvec3 polar(double theta, double phi) { return test::polar(std::cos(theta * radians), phi * radians); }

double value(const Raster& raster, dvec3 h) { return raster_value(raster.values, side, disk_point(h)); }

Raster stroked(const Raster& before, const StrokeStyle& style, dvec3 from, dvec3 to) {
    Stroke stroke(before, style, from);
    stroke.move_to(to);
    return *stroke.raster();
}

// A ring of paint at 40 degrees about the axis.
Raster ring() {
    return stroked(blank(), {PaintTool::ring, {.radius = 4, .hardness = 0.9, .flow = 1}, {}, nullptr},
                   {0, 0, 1}, polar(40, 0));
}

Raster filled(const Raster& before, dvec3 at, const Brush& brush, const BrushSymmetry& symmetry = {}) {
    return stroked(before, {.tool = PaintTool::fill, .brush = brush, .symmetry = symmetry, .tip = {}}, at,
                   at);
}

// The share of the disk's texels whose value is near to one.
double part_near(const Raster& raster, double wanted) {
    int near = 0, all = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            if (!holds_facets(texel_point(side, i, j))) continue;
            ++all;
            near += std::abs(static_cast<double>(raster.values[static_cast<std::size_t>(i * side + j)]) -
                             wanted) < 1e-3;
        }
    return static_cast<double>(near) / all;
}

// The disk's area within a polar angle.
double cap(double theta) { return 1 - std::cos(theta * radians); }

}  // namespace

TEST_CASE("fill: what a ring goes around, and nothing beyond it") {
    const Raster before = ring();
    const Raster inside = filled(before, polar(10, 200), {.value = 0.6});
    CHECK(value(inside, {0, 0, 1}) == doctest::Approx(0.6));
    CHECK(value(inside, polar(30, 77)) == doctest::Approx(0.6));
    CHECK(value(inside, polar(60, 77)) == 0);
    CHECK(value(inside, polar(40, 77)) == doctest::Approx(1));
    CHECK(part_near(inside, 0.6) == doctest::Approx(cap(36)).epsilon(0.03));
    const Raster outside = filled(before, polar(70, 3), {.value = 0.6});
    CHECK(value(outside, {0, 0, 1}) == 0);
    CHECK(value(outside, polar(89.9, 200)) == doctest::Approx(0.6));
    CHECK(part_near(outside, 0.6) == doctest::Approx(1 - cap(44)).epsilon(0.03));
    const Raster on_it = filled(before, polar(40, 50), {.value = 0.2});
    CHECK(value(on_it, polar(40, 250)) == doctest::Approx(0.2));
    CHECK(value(on_it, polar(60, 250)) == 0);
}

TEST_CASE("fill: the tolerance says what is like, all of it fills everything") {
    Raster slope = blank();
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            slope.values[static_cast<std::size_t>(i * side + j)] = static_cast<float>(j) / side;
    const auto reached = [&](double tolerance) {
        StrokeStyle style{.tool = PaintTool::fill, .brush = {}, .symmetry = {}, .tip = {}};
        style.tolerance = tolerance;
        return stroked(slope, style, {0, 0, 1}, {0, 0, 1});
    };
    const Raster near = reached(0.1);
    const auto row = [&](const Raster& raster, int column) {
        return raster.values[static_cast<std::size_t>(side / 2 * side + column)];
    };
    CHECK(row(near, 128 + 25) == 1);
    CHECK(row(near, 128 - 25) == 1);
    CHECK(row(near, 128 + 28) == row(slope, 128 + 28));
    CHECK(row(near, 128 - 28) == row(slope, 128 - 28));
    CHECK(part_near(reached(1), 1) == 1);
}

TEST_CASE("fill: as paint combines, by value and opacity") {
    const Raster half{side, side, std::vector<float>(std::size_t{side} * side, 0.5f)};
    const auto middle = [&](Brush brush) { return value(filled(half, {0, 0, 1}, brush), polar(20, 20)); };
    CHECK(middle({.value = 0.2}) == doctest::Approx(0.2));
    CHECK(middle({.opacity = 0.5, .value = 0.2}) == doctest::Approx(0.35));
    CHECK(middle({.value = 0.2, .blend = Blend::add}) == doctest::Approx(0.7));
    CHECK(middle({.value = 0.8, .blend = Blend::add}) == doctest::Approx(1));
    CHECK(middle({.value = 0.2, .blend = Blend::multiply}) == doctest::Approx(0.1));
    CHECK(middle({.value = 0.2, .blend = Blend::maximum}) == doctest::Approx(0.5));
    CHECK(middle({.value = 0.8, .blend = Blend::maximum}) == doctest::Approx(0.8));
}

TEST_CASE("fill: each copy of the press fills where it lies") {
    Raster before = blank();
    for (const double x : {-1.0, 1.0})
        before = stroked(before, {PaintTool::ring, {.radius = 3, .hardness = 0.9, .flow = 1}, {}, nullptr},
                         polar(45, x < 0 ? 180 : 0), polar(60, x < 0 ? 180 : 0));
    const Raster both = filled(before, polar(45, 0), {.value = 0.5}, {SymmetryKind::mirror_x, 6});
    CHECK(value(both, polar(45, 0)) == doctest::Approx(0.5));
    CHECK(value(both, polar(45, 180)) == doctest::Approx(0.5));
    CHECK(value(both, {0, 0, 1}) == 0);
    // All around: as the meridian through the press has it.
    const Raster around = filled(before, polar(45, 0), {.value = 0.5}, {SymmetryKind::ring, 6});
    CHECK(value(around, polar(45, 90)) == doctest::Approx(0.5));
    CHECK(value(around, polar(45, 230)) == doctest::Approx(0.5));
    CHECK(value(around, polar(10, 230)) == 0);
}

TEST_CASE("gradient: linear by the angle from press to pointer, full behind and none beyond") {
    const dvec3 from = polar(30, 180), to = polar(60, 0);
    const StrokeStyle style{.tool = PaintTool::gradient, .brush = {.value = 0.8}, .symmetry = {}, .tip = {}};
    const Raster raster = stroked(blank(), style, from, to);
    for (const double theta : {-25, -10, 0, 15, 40, 55})
        CHECK(value(raster, polar(std::abs(theta), theta < 0 ? 180 : 0)) ==
              doctest::Approx(0.8 * (1 - (theta + 30) / 90)).epsilon(2e-3));
    CHECK(value(raster, polar(50, 180)) == doctest::Approx(0.8));
    CHECK(value(raster, polar(75, 0)) == 0);
    // The same left and right of the way, and no line of it runs together at the rim.
    CHECK(value(raster, polar(40, 50)) == doctest::Approx(value(raster, polar(40, -50))).epsilon(1e-3));
    CHECK(std::abs(value(raster, polar(88, 88)) - value(raster, polar(88, 92))) < 0.05);
}

TEST_CASE("gradient: radial about the press; mirrored to the bit; without a way there is none") {
    StrokeStyle style{.tool = PaintTool::gradient, .brush = {}, .symmetry = {}, .tip = {}};
    style.form = GradientForm::radial;
    const Raster raster = stroked(blank(), style, polar(20, 0), polar(50, 0));
    const dvec3 off = glm::normalize(polar(20, 0) + std::tan(15 * radians) * dvec3(0, 1, 0));
    CHECK(value(raster, off) == doctest::Approx(0.5).epsilon(5e-3));
    CHECK(value(raster, polar(20, 0)) > 0.98);
    CHECK(value(raster, polar(51, 0)) == 0);
    style.symmetry.kind = SymmetryKind::mirror_x;
    const Raster both = stroked(blank(), style, polar(20, 0), polar(50, 0));
    int wrong = 0;
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j)
            wrong += both.values[i * side + j] != both.values[i * side + side - 1 - j];
    CHECK(wrong == 0);
    CHECK(value(both, polar(20, 180)) > 0.98);
    CHECK(stroked(blank(), style, polar(20, 0), polar(20, 0)) == blank());
}

TEST_CASE("selection: every tool keeps to it, and takes its soft rim in proportion") {
    auto shares = std::make_shared<TexelShares>(std::size_t{side} * side);
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j)
            (*shares)[i * side + j] = j < 128 ? 0.0f : j == 128 ? 0.25f : 1.0f;
    const Raster before{side, side, std::vector<float>(std::size_t{side} * side, 0.5f)};
    for (const PaintTool tool : paint_tools) {
        CAPTURE(info(tool).face.name);
        StrokeStyle style{.tool = tool,
                          .brush = {.radius = 20, .hardness = 1, .flow = 1, .value = 1},
                          .symmetry = {},
                          .tip = std::make_shared<const Raster>(Raster{1, 1, {1}})};
        style.selected = shares;
        Raster rough = before;
        if (tool == PaintTool::smooth || tool == PaintTool::smear)
            for (std::size_t i = 0; i < rough.values.size(); ++i)
                rough.values[i] = static_cast<float>((i * 7919) % 97) / 97;
        const Raster after = stroked(rough, style, polar(3, 0), polar(30, 3));
        const Raster back = stroked(rough, style, polar(3, 180), polar(30, 177));
        style.selected = nullptr;
        const Raster free = stroked(rough, style, polar(3, 0), polar(30, 3));
        int wrong = 0;
        for (std::size_t i = 0; i < side; ++i)
            for (std::size_t j = 0; j < side; ++j) {
                const std::size_t at = i * side + j;
                wrong +=
                    j < 128 && (after.values[at] != rough.values[at] || back.values[at] != rough.values[at]);
            }
        CHECK(wrong == 0);
        CHECK(after != rough);
        if (tool == PaintTool::fill) continue;  // it does not go through what is not selected
        double worst = 0;
        for (std::size_t at = 128; at < rough.values.size(); at += side)
            worst = std::max(worst, std::abs(static_cast<double>(after.values[at] - rough.values[at]) -
                                             0.25 * static_cast<double>(free.values[at] - rough.values[at])));
        CHECK(worst < 1e-6);
    }
}

TEST_CASE("selection: a fill does not go around through what is not selected") {
    // Two strips, with a gap between them that is not selected.
    auto shares = std::make_shared<TexelShares>(std::size_t{side} * side);
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j)
            (*shares)[i * side + j] = (j > 60 && j < 100) || (j > 140 && j < 180) ? 1.0f : 0.0f;
    StrokeStyle style{.tool = PaintTool::fill, .brush = {}, .symmetry = {}, .tip = {}};
    style.selected = shares;
    const Raster raster = stroked(blank(), style, disk_direction({-0.4, 0}), {0, 0, 1});
    const auto at = [&](std::size_t column) { return raster.values[side / 2 * side + column]; };
    CHECK(at(80) == 1);
    CHECK(at(120) == 0);
    CHECK(at(160) == 0);
    CHECK(stroked(blank(), style, {0, 0, 1}, {0, 0, 1}) == blank());
}
