#include "core/paint/normal_map.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/design/error.h"
#include "core/exchange/image_file.h"
#include "core/model/facet_distribution.h"
#include "core/paint/raster_texels.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;

namespace {

FacetDistribution p_of(std::shared_ptr<const Raster> raster) {
    return FacetDistribution(test::design_of(PaintedLobe{{{}, std::move(raster)}}).distribution);
}

}  // namespace

TEST_CASE("normal map: each normal counts by its facets' area") {
    // Nine tenths of the area seen from above lie flat, one tenth leans by 60 degrees: twice as many facets.
    std::vector<dvec3> normals(900, dvec3(0, 0, 1));
    normals.insert(normals.end(), 100, dvec3(std::sqrt(0.75), 0, 0.5));
    const FacetDistribution p = p_of(raster_of_normals(normals, 0));
    const dvec3 expected = (900.0 * dvec3(0, 0, 1) + 200.0 * dvec3(std::sqrt(0.75), 0, 0.5)) / 1100.0;
    CHECK(glm::length(p.mean() - expected) < 2e-3);
    CHECK_THROWS_AS(raster_of_normals({}, 1), UserError);
    CHECK_THROWS_AS(raster_of_normals({{0, 0, -1}}, 1), UserError);
}

TEST_CASE("normal map: the width is the standard deviation of what was one normal") {
    const FacetDistribution p = p_of(raster_of_normals({{0, 0, 1}}, 5));
    double sum = 0, weight = 0;
    const auto facets = p.facets(0);
    for (const Facet& facet : facets.front()) {
        sum += facet.mass * facet.h.x * facet.h.x;
        weight += facet.mass;
    }
    CHECK(std::sqrt(sum / weight) * 180 / std::numbers::pi == doctest::Approx(5).epsilon(0.02));
}

TEST_CASE("normal map: a Gaussian surface gives the Gaussian back") {
    // Slopes of a Beckmann surface of width 0.3 along x and 0.15 along y, seen from above.
    Random random(7);
    std::normal_distribution<double> normal;
    std::vector<dvec3> normals;
    for (int i = 0; i < 200000; ++i)
        normals.push_back(glm::normalize(dvec3(-0.3 * std::numbers::sqrt2 / 2 * normal(random),
                                               -0.15 * std::numbers::sqrt2 / 2 * normal(random), 1)));
    const FacetDistribution found = p_of(raster_of_normals(normals, 0));
    const FacetDistribution expected(test::design_of(BeckmannLobe{0.3, 0.15}).distribution);
    for (const double cosine : {1.0, 0.9, 0.6, 0.3})
        for (const double phi : {0.0, 0.8, 1.6}) {
            const dvec3 k = test::polar(cosine, phi);
            CHECK(found.projected_area(k) == doctest::Approx(expected.projected_area(k)).epsilon(0.01));
        }
}

TEST_CASE("normal map: pictures are read as directions, heights as slopes across their lines") {
    const ColourPicture flat{1, 1, {{0.5f, 0.5f, 1.0f}}};
    CHECK(glm::length(normals_of_map(flat).at(0) - dvec3(0, 0, 1)) < 1e-6);
    const ColourPicture leaning{2, 1, {{1.0f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.2f}}};
    CHECK(normals_of_map(leaning).empty());  // neither faces up
    const ColourPicture as_is{2, 1, {{-0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}}};
    CHECK(glm::length(normals_of_map(as_is).at(0) - dvec3(-0.6, 0, 0.8)) < 1e-6);
    // Rising to the right, with a jump where it begins anew.
    ColourPicture ramp{8, 8, {}};
    for (int i = 0; i < 64; ++i) ramp.colours.push_back(glm::vec3(static_cast<float>(i % 8) / 8));
    const dvec3 n = normals_of_heights(ramp, 1).at(8 * 4 + 4);
    CHECK(n.x == doctest::Approx(-1 / std::numbers::sqrt2));
    CHECK(n.y == 0);
    CHECK(normals_of_heights(ramp, -1).at(8 * 4 + 4) == dvec3(-n.x, n.y, n.z));  // hollows for hills
    CHECK(normals_of_heights(ramp, 0).at(8 * 4 + 4) == dvec3(0, 0, 1));
}

TEST_CASE("normal map: files of any shape are read, what is none is told") {
    const test::TemporaryFolder folder;
    const std::vector<float> rgb = {0.5f, 0.5f,  1, 0.5f, 0.5f, 1, 0.75f, 0.5f, 1,
                                    0.5f, 0.25f, 1, 0.5f, 0.5f, 1, 0.5f,  0.5f, 1};
    write_image(folder.path() / "wide.exr", {3, 2}, rgb);
    const ColourPicture picture = load_colours(folder.path() / "wide.exr");
    CHECK(picture.width == 3);
    CHECK(picture.height == 2);
    CHECK(picture.colours.at(2) == glm::vec3(0.75f, 0.5f, 1));
    CHECK_THROWS_AS(load_colours(folder.path() / "none.png"), UserError);
}
