#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/moment_pyramid.h"
#include "core/model/picture_lobe.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using nacre::test::random_direction;

namespace {

constexpr int side = 128;

// Facets on a grid of directions over the upper hemisphere, many of them empty.
std::vector<Facet> random_facets(Random& random, double share) {
    std::vector<Facet> facets;
    for (int i = 0; i < side * side; ++i) {
        const double z = (i / side + 0.5) / side, phi = 2 * std::numbers::pi * (i % side + 0.5) / side;
        const double s = std::sqrt(1 - z * z);
        const bool filled = uniform_random(random) < share;
        facets.push_back({{s * std::cos(phi), s * std::sin(phi), z}, filled ? uniform_random(random) : 0});
    }
    return facets;
}

MomentPyramid pyramid_of(const std::vector<Facet>& facets) {
    return {side, [&](int row, int column) { return facets[static_cast<std::size_t>(row * side + column)]; }};
}

Area plain_sum(const std::vector<Facet>& facets, dvec3 k) {
    Area sum;
    for (const Facet& facet : facets) {
        const double seen = glm::dot(k, facet.h);
        if (seen <= 0) continue;
        sum.g += facet.mass * seen;
        sum.gradient += facet.mass * facet.h;
    }
    return sum;
}

Layer painted_layer(int size, Random& random) {
    Raster raster{size, size, {}};
    for (int i = 0; i < size * size; ++i)
        raster.values.push_back(static_cast<float>(std::fmax(0.0, uniform_random(random) - 0.4)));
    Layer layer;
    layer.lobe = PaintedLobe{{{}, std::make_shared<const Raster>(raster)}};
    return layer;
}

}  // namespace

TEST_CASE("the pyramid is the sum over all facets") {
    Random random(1);
    for (const double share : {1.0, 0.5, 0.01, 1e-4}) {
        const std::vector<Facet> facets = random_facets(random, share);
        const MomentPyramid pyramid = pyramid_of(facets);
        dvec3 mean{0};
        double mass = 0;
        for (const Facet& facet : facets) {
            mean += facet.mass * facet.h;
            mass += facet.mass;
        }
        CHECK(glm::length(pyramid.mean() - mean) <= 1e-13 * mass);
        CHECK(std::fabs(pyramid.mass() - mass) <= 1e-13 * mass);
        for (int i = 0; i < 200; ++i) {
            const dvec3 k = random_direction(random) * (i % 2 ? 1.0 : -1.0);
            const Area exact = plain_sum(facets, k), area = pyramid.area(k);
            CHECK(std::fabs(area.g - exact.g) <= 1e-13 * mass);
            CHECK(glm::length(area.gradient - exact.gradient) <= 1e-13 * mass);
        }
    }
}

TEST_CASE("few cells hold all of the facets' area") {
    Random random(2);
    const MomentPyramid pyramid = pyramid_of(random_facets(random, 0.3));
    for (const std::size_t count : {16U, 100U, 1000U, 100000U}) {
        const std::vector<Facet> cells = pyramid.facets(count);
        CHECK(cells.size() <= count);
        dvec3 sum{0};
        for (const Facet& cell : cells) sum += cell.mass * cell.h;
        CHECK(glm::length(sum - pyramid.mean()) <= 1e-12 * pyramid.mass());
    }
    CHECK(pyramid.facets(100000).size() == pyramid.facets(0).size());
}

TEST_CASE("facets are drawn as k sees them") {
    Random random(3);
    const std::vector<Facet> facets = random_facets(random, 0.002);
    const MomentPyramid pyramid = pyramid_of(facets);
    const dvec3 k = glm::normalize(dvec3{0.9, 0.1, 0.2});
    std::vector<int> drawn(facets.size());
    constexpr int draws = 100000;
    for (int i = 0; i < draws; ++i) ++drawn[pyramid.sample_visible(k, random)];
    const double g = pyramid.area(k).g;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const double p = std::fmax(glm::dot(k, facets[i].h), 0.0) * facets[i].mass / g;
        CHECK(std::fabs(drawn[i] - draws * p) <= 6 * std::sqrt(draws * p) + 1e-9);
    }
}

TEST_CASE("a painted lobe after a touch is the lobe made anew, and its changes are the difference") {
    Random random(4);
    for (const int size : {64, 256, 300}) {
        CAPTURE(size);
        const Layer before = painted_layer(size, random);
        Layer after = before;
        Raster raster = *std::get<PaintedLobe>(before.lobe).image.raster;
        for (int row = size / 3; row < size / 3 + 9; ++row)
            for (int column = size / 2; column < size / 2 + 5; ++column)
                raster.values[static_cast<std::size_t>(row * size + column)] += 0.5F;
        std::get<PaintedLobe>(after.lobe).image.raster = std::make_shared<const Raster>(raster);
        const auto old = make_lobe(before), anew = make_lobe(after);
        const auto touched = repaint(*old, after);
        REQUIRE(touched);
        const auto changes = painted_between(*old, *touched);
        REQUIRE(changes);
        CHECK(touched->mass() == anew->mass());
        for (int i = 0; i < 100; ++i) {
            const dvec3 k = random_direction(random);
            const Area a = touched->area(k), b = anew->area(k);
            CHECK((a.g == b.g && a.gradient == b.gradient));
            double change = 0;
            for (const Facet& facet : *changes) change += facet.mass * std::fmax(glm::dot(k, facet.h), 0.0);
            // But for what the changed facets spread where k sees them from the side.
            CHECK(std::fabs(old->area(k).g + change - b.g) <= 1e-5 * anew->mass());
        }
    }
    const Layer other_size = painted_layer(128, random);
    CHECK_FALSE(repaint(*make_lobe(painted_layer(64, random)), other_size));
    CHECK_FALSE(painted_between(*make_lobe(painted_layer(64, random)), *make_lobe(other_size)));
    Layer modulated = painted_layer(64, random);
    const auto plain = make_lobe(modulated);
    modulated.modulation = Modulation{std::get<PaintedLobe>(modulated.lobe).image, 1};
    CHECK_FALSE(repaint(*plain, modulated));
    CHECK_FALSE(painted_between(*plain, *make_lobe(modulated)));
}
