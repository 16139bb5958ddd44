// What is selected on the canvas.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/model/facet_distribution.h"
#include "core/paint/contour.h"
#include "core/paint/polygon_cover.h"
#include "core/paint/raster_texels.h"
#include "core/paint/select_tool.h"
#include "core/paint/selection.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

constexpr double radians = std::numbers::pi / 180;

dvec3 polar(double theta, double phi) { return test::polar(std::cos(theta * radians), phi * radians); }

using Outline = std::vector<glm::dvec2>;

// A square on the canvas about a normal, so many pixels a side.
Outline square_about(const HemisphereView& view, dvec3 h, double side) {
    const glm::dvec2 at = view.pixel(h);
    const std::vector<glm::dvec2> way = {at - 0.5 * side, at, at + 0.5 * side};
    return info(SelectTool::rectangle).outline(way);
}

}  // namespace

TEST_CASE("polygon: it covers pixels in part, and is whole where it goes around twice") {
    const Outline square = {{2.5, 3}, {6, 3}, {6, 8.25}, {2.5, 8.25}};
    const PolygonCover cover(square);
    CHECK(cover({4.5, 5.5}) == 1);
    CHECK(cover({2.5, 5.5}) == doctest::Approx(0.5));
    CHECK(cover({4.5, 8.5}) == doctest::Approx(0.25));
    CHECK(cover({1, 5}) == 0);
    CHECK(cover({4.5, 20}) == 0);
    Outline twice = square;
    twice.insert(twice.end(), square.begin(), square.end());
    CHECK(PolygonCover(twice)({4.5, 5.5}) == 1);
    CHECK(PolygonCover(Outline{{1, 1}, {2, 2}})({1.5, 1.5}) == 0);
}

TEST_CASE("contour: closed lines, one for each area and each hole, as long as they are") {
    const auto ring = [](int row, int column) {
        const double r = std::hypot(row - 30, column - 30);
        return std::clamp(20.5 - r, 0.0, 1.0) * std::clamp(r - 9.5, 0.0, 1.0);
    };
    const auto lines = contours(61, ring);
    REQUIRE(lines.size() == 2);
    double longest = 0, shortest = 1e9;
    for (const auto& line : lines) {
        double length = 0;
        for (std::size_t i = 0; i < line.size(); ++i)
            length += glm::length(line[i] - line[(i + 1) % line.size()]);
        longest = std::max(longest, length), shortest = std::min(shortest, length);
        for (const glm::dvec2& at : line) {
            const double r = glm::length(at - 30.0);
            CHECK((std::abs(r - 20) < 0.2 || std::abs(r - 10) < 0.2));
        }
    }
    CHECK(longest == doctest::Approx(2 * std::numbers::pi * 20).epsilon(0.02));
    CHECK(shortest == doctest::Approx(2 * std::numbers::pi * 10).epsilon(0.02));
    CHECK(contours(8, [](int, int) { return 1.0; }).size() == 1);
    CHECK(contours(8, [](int, int) { return 0.0; }).empty());
}

TEST_CASE("selection: what lies in the outline, as highlight, as facets and on the dome") {
    for (const HemisphereCamera& camera :
         {HemisphereCamera{}, HemisphereCamera{.highlight = false}, HemisphereCamera{.dome = true}}) {
        const HemisphereView view(camera, {600, 500});
        const dvec3 middle = polar(30, 200);
        const auto selection = select(nullptr, SelectMode::replace, view, square_about(view, middle, 60));
        REQUIRE(selection);
        CHECK((*selection)(middle) == doctest::Approx(1));
        CHECK((*selection)(polar(30, 20)) == 0);
        const auto at = [&](glm::dvec2 off) {
            return (*selection)(*view.direction(view.pixel(middle) + off));
        };
        CHECK(at({28, -28}) > 0.9);
        CHECK(at({32, 0}) < 0.1);
        CHECK(at({0, -32}) < 0.1);
        CHECK(at({30, 0}) == doctest::Approx(0.5).epsilon(0.3));
    }
}

TEST_CASE("selection: added, taken away, inverted, all and none") {
    const HemisphereView view({}, {600, 600});
    const dvec3 a = polar(30, 0), b = polar(30, 180);
    const auto first = select(nullptr, SelectMode::replace, view, square_about(view, a, 50));
    const auto both = select(first.get(), SelectMode::add, view, square_about(view, b, 50));
    CHECK((*both)(a) == doctest::Approx(1));
    CHECK((*both)(b) == doctest::Approx(1));
    CHECK(both->outlines(false).size() == 2);
    const auto second = select(both.get(), SelectMode::remove, view, square_about(view, a, 60));
    CHECK((*second)(a) == 0);
    CHECK((*second)(b) == doctest::Approx(1));
    CHECK(select(second.get(), SelectMode::remove, view, square_about(view, b, 60)) == nullptr);
    CHECK(select(nullptr, SelectMode::remove, view, square_about(view, b, 60)) == nullptr);
    const auto rest = inverted(*both);
    CHECK((*rest)(a) == 0);
    CHECK((*rest)({0, 0, 1}) == doctest::Approx(1));
    CHECK(rest->outlines(false).size() == 3);
    const auto all = select_all();
    CHECK((*all)(polar(89, 33)) == doctest::Approx(1));
    CHECK((*all)(polar(140, 33)) == doctest::Approx(1));
    CHECK(all->outlines(false).size() == 1);
    for (const glm::dvec2& at : all->outlines(false)[0])
        CHECK(glm::length(at) == doctest::Approx(1).epsilon(2e-3));
    CHECK(inverted(*all) == nullptr);
}

TEST_CASE("selection: it stays where it is seen, however the layer leans") {
    const HemisphereView view({}, {600, 600});
    const dvec3 middle = polar(40, 70);
    const auto selection = select(nullptr, SelectMode::replace, view, square_about(view, middle, 60));
    Layer layer;
    layer.tilt = 25;
    layer.azimuth = 100;
    layer.rotation = 33;
    const glm::dmat3 frame = layer_frame(layer);
    const auto shares = selection->texels(frame, 256);
    double worst = 0;
    visit_texels(256, {0, 0, 1}, 4, [&](std::size_t index, dvec3 h) {
        worst = std::max(worst, std::abs(static_cast<double>((*shares)[index]) - (*selection)(frame * h)));
    });
    CHECK(worst < 1e-6);
    CHECK(raster_value(*shares, 256, disk_point(glm::transpose(frame) * middle)) == doctest::Approx(1));
}
