// What is selected of a raster, elsewhere.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/model/facet_distribution.h"
#include "core/paint/raster_texels.h"
#include "core/paint/transform.h"

using namespace nacre;

namespace {

constexpr int side = 256;

// A soft dot on the disk.
std::shared_ptr<const Raster> dot(dvec2 middle, double radius, float floor = 0) {
    auto raster =
        std::make_shared<Raster>(Raster{side, side, std::vector<float>(std::size_t{side} * side, floor)});
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double r = glm::length(texel_point(side, i, j) - middle) / radius;
            if (r < 1)
                raster->values[static_cast<std::size_t>(i * side + j)] =
                    std::max(floor, static_cast<float>((1 - r * r) * (1 - r * r)));
        }
    return raster;
}

double value(const Raster& raster, dvec2 at) { return raster_value(raster.values, side, at); }

std::shared_ptr<const TexelShares> selected(const std::function<bool(dvec2)>& inside) {
    auto shares = std::make_shared<TexelShares>(std::size_t{side} * side);
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            (*shares)[static_cast<std::size_t>(i * side + j)] = inside(texel_point(side, i, j)) ? 1.0f : 0.0f;
    return shares;
}

}  // namespace

TEST_CASE("transform: the box lies about what is painted, and where it stays nothing changes") {
    const auto before = dot({0.3, -0.2}, 0.2);
    const auto transform = Transform::of(before, glm::dmat3(1), nullptr);
    REQUIRE(transform);
    CHECK(glm::length(transform->box().middle - dvec2(0.3, -0.2)) < 5e-3);
    CHECK(transform->box().right.x == doctest::Approx(0.2).epsilon(0.06));
    CHECK(transform->box().up.y == doctest::Approx(0.2).epsilon(0.06));
    CHECK(transform->carried(transform->box(), Blend::replace) == before);
    CHECK(!Transform::of(
        std::make_shared<Raster>(Raster{side, side, std::vector<float>(std::size_t{side} * side)}),
        glm::dmat3(1), nullptr));
}

TEST_CASE("transform: moved, turned and stretched, each texel has what lay where it comes from") {
    const auto before = dot({0.3, -0.2}, 0.2);
    const auto transform = *Transform::of(before, glm::dmat3(1), nullptr);
    DiskBox box = transform.box();
    box.middle += dvec2(-0.5, 0.3);
    const auto moved = transform.carried(box, Blend::replace);
    double worst = 0;
    for (const dvec2 at : {dvec2(0.3, -0.2), {0.35, -0.2}, {0.3, -0.1}, {0.22, -0.28}})
        worst = std::max(worst, std::abs(value(*moved, at + dvec2(-0.5, 0.3)) - value(*before, at)));
    CHECK(worst < 0.01);
    CHECK(value(*moved, {0.3, -0.2}) == 0);
    CHECK(raster_mass(*moved) == doctest::Approx(raster_mass(*before)).epsilon(1e-3));

    // Twice as wide: half as steep, no hole.
    box = transform.box();
    box.right *= 2.0;
    const auto wide = transform.carried(box, Blend::replace);
    for (double x = -0.38; x < 0.38; x += 0.01)
        CHECK(value(*wide, {0.3 + x, -0.2}) ==
              doctest::Approx(value(*before, {0.3 + x / 2, -0.2})).epsilon(0.03));
    CHECK(raster_mass(*wide) == doctest::Approx(2 * raster_mass(*before)).epsilon(0.01));

    // A quarter turn of it carries right to up.
    const auto quarter = transform.carried(turned(box, std::numbers::pi / 2), Blend::replace);
    CHECK(value(*quarter, {0.3, 0.05}) == doctest::Approx(value(*wide, {0.55, -0.2})).epsilon(0.02));
    CHECK(value(*quarter, {0.55, -0.2}) == 0);
}

TEST_CASE("transform: of a selection alone, combined with what is left") {
    const auto before = dot({0.4, 0}, 0.25, 0.3f);
    const auto there = selected([](dvec2 at) { return std::abs(at.x - 0.4) < 0.3 && std::abs(at.y) < 0.3; });
    const auto transform = *Transform::of(before, glm::dmat3(1), there);
    CHECK(transform.box().right.x == doctest::Approx(0.3).epsilon(0.05));
    DiskBox box = transform.box();
    box.middle.x = -0.4;
    const auto middle = [&](Blend blend, dvec2 at) { return value(*transform.carried(box, blend), at); };
    CHECK(middle(Blend::replace, {-0.4, 0}) == doctest::Approx(1).epsilon(0.01));
    CHECK(middle(Blend::add, {-0.4, 0}) == doctest::Approx(1));
    CHECK(middle(Blend::add, {-0.4, 0.28}) == doctest::Approx(0.6));
    CHECK(middle(Blend::multiply, {-0.4, 0.28}) == doctest::Approx(0.09));
    CHECK(middle(Blend::maximum, {-0.4, 0.28}) == doctest::Approx(0.3));
    for (const Blend blend : {Blend::replace, Blend::add, Blend::multiply, Blend::maximum}) {
        CHECK(middle(blend, {0.4, 0}) == 0);                     // it was cut out there
        CHECK(middle(blend, {0, 0.6}) == doctest::Approx(0.3));  // and nothing else was touched
    }
}

TEST_CASE(
    "transform: of a selection the box lies about what is painted in it, or about all where nothing is") {
    const auto before = dot({0.3, -0.2}, 0.2);
    const auto everything = selected([](dvec2) { return true; });
    CHECK(Transform::of(before, glm::dmat3(1), everything)->box() ==
          Transform::of(before, glm::dmat3(1), nullptr)->box());
    const auto beside = selected([](dvec2 at) { return at.x < -0.2 && at.x > -0.6 && std::abs(at.y) < 0.3; });
    CHECK(glm::length(Transform::of(before, glm::dmat3(1), beside)->box().middle - dvec2(-0.4, 0)) < 0.01);
    CHECK(!Transform::of(before, glm::dmat3(1), selected([](dvec2) { return false; })));
}

TEST_CASE("transform: on a layer that leans it goes as the surface's disk shows it") {
    Layer layer;
    layer.tilt = 30;
    layer.azimuth = 40;
    const glm::dmat3 frame = layer_frame(layer);
    const auto before = dot({0, 0}, 0.2);
    const auto transform = *Transform::of(before, frame, nullptr);
    const dvec2 there = disk_point(frame[2]);
    CHECK(glm::length(transform.box().middle - there) < 0.02);
    DiskBox box = transform.box();
    box.middle += dvec2(-0.3, -0.4);
    const auto moved = transform.carried(box, Blend::replace);
    const dvec2 now = disk_point(glm::transpose(frame) * disk_direction(there + dvec2(-0.3, -0.4)));
    CHECK(value(*moved, now) == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("transform: pulled by a corner or a side, what lies across stays; it opens again however thin") {
    const DiskBox box{{0.1, 0.2}, {0.3, 0.1}, {-0.05, 0.2}};
    const DiskBox corner = pulled(box, {1, 1}, {0.6, 0.7}, false);
    CHECK(glm::length(corner.at({1, 1}) - dvec2(0.6, 0.7)) < 1e-12);
    CHECK(glm::length(corner.at({-1, -1}) - box.at({-1, -1})) < 1e-12);
    const DiskBox edge = pulled(box, {-1, 0}, box.at({-2, 0.4}), false);
    CHECK(glm::length(edge.at({-1, 0}) - box.at({-2, 0})) < 1e-12);
    CHECK(glm::length(edge.at({1, 1}) - box.at({1, 1})) < 1e-12);
    const DiskBox even = pulled(box, {1, 1}, box.at({3, 1}), true);
    CHECK(glm::length(even.right) / glm::length(box.right) == doctest::Approx(2));
    CHECK(glm::length(even.up) / glm::length(box.up) == doctest::Approx(2));
    const DiskBox mirrored = pulled(box, {1, 0}, box.at({-3, 0}), false);
    CHECK(glm::dot(mirrored.right, box.right) < 0);
    const DiskBox flat = pulled(box, {1, 0}, box.at({-1, 0}), false);
    CHECK(glm::length(flat.right) > 0);
    CHECK(glm::length(pulled(flat, {1, 0}, box.at({1, 0}), false).at({1, 0}) - box.at({1, 0})) < 1e-9);
}
