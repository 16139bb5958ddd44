#include "core/paint/normal_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/image/image_file.h"
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

namespace {

// A wavy surface, which is steeper than it is wide along y; both waves go round the picture.
dvec3 wave(int row, int column, int side) {
    const double turn = 2 * std::numbers::pi / side;
    const double x = 0.4 * std::cos(turn * 3 * column + turn * row),
                 y = -0.4 / 3 * std::cos(turn * 3 * column + turn * row) + 0.3 * std::sin(turn * 2 * row);
    return glm::normalize(dvec3(-x, -y, 1));  // rows go down, y up
}

constexpr int wave_side = 64;

ColourPicture wavy(const NormalReading& reading, bool integers, float blue = 0) {
    ColourPicture picture{wave_side, wave_side, {}, 3, integers};
    for (int row = 0; row < wave_side; ++row)
        for (int column = 0; column < wave_side; ++column) {
            dvec3 n = wave(row, column, wave_side);
            if (reading.green_down) n.y = -n.y;
            if (!reading.is_signed) n = 0.5 + 0.5 * n;
            glm::vec3 colour(n);
            if (reading.two_channels) colour.z = blue;
            if (integers) colour = glm::round(colour * 255.0f) / 255.0f;
            picture.colours.push_back(colour);
        }
    return picture;
}

double worst_error(const std::vector<dvec3>& normals) {
    REQUIRE(normals.size() == wave_side * wave_side);
    double worst = 0;
    for (int i = 0; i < wave_side * wave_side; ++i)
        worst = std::max(worst, glm::length(normals[static_cast<std::size_t>(i)] -
                                            wave(i / wave_side, i % wave_side, wave_side)));
    return worst;
}

}  // namespace

TEST_CASE("normal map: the map as a whole tells how its numbers are meant, and gives its normals back") {
    for (const bool integers : {false, true})
        for (const bool is_signed : {false, true})
            for (const bool two : {false, true})
                for (const bool down : {false, true})
                    for (const float blue : {0.0f, 0.5f, 1.0f}) {
                        if (is_signed && integers) continue;
                        const NormalReading meant{is_signed, two, down};
                        CAPTURE(integers);
                        CAPTURE(is_signed);
                        CAPTURE(two);
                        CAPTURE(down);
                        CAPTURE(blue);
                        const ColourPicture picture = wavy(meant, integers, blue);
                        NormalMapLook look = look_at_normal_map(picture);
                        CHECK(look.reading == NormalReading{is_signed, two, false});
                        REQUIRE(look.green_down);
                        CHECK(*look.green_down == down);
                        look.reading.green_down = down;
                        CHECK(worst_error(normals_of_map(picture, look.reading)) < (integers ? 0.03 : 1e-5));
                    }
}

TEST_CASE("normal map: a file of two channels needs no blue") {
    for (const bool is_signed : {false, true}) {
        ColourPicture picture = wavy({is_signed, true, false}, false);
        picture.channels = 2;
        const NormalMapLook look = look_at_normal_map(picture);
        CHECK(look.reading == NormalReading{is_signed, true, false});
        CHECK(worst_error(normals_of_map(picture, look.reading)) < 1e-5);
        // Flat ones.
        std::fill(picture.colours.begin(), picture.colours.end(),
                  glm::vec3(is_signed ? 0 : 0.5f, is_signed ? 0 : 0.5f, 0));
        const NormalMapLook flat = look_at_normal_map(picture);
        CHECK(flat.reading == NormalReading{is_signed, true, false});
        CHECK(!flat.green_down);
        CHECK(normals_of_map(picture, flat.reading).front() == dvec3(0, 0, 1));
        CHECK(count_normals(picture, flat.reading).empty == 0);
    }
    ColourPicture grey{1, 1, {glm::vec3(0.5f)}, 1};
    CHECK_THROWS_AS(normals_of_map(grey, look_at_normal_map(grey).reading), UserError);
}

TEST_CASE("normal map: a few pixels that filters left do not change what all others say") {
    for (const bool is_signed : {false, true}) {
        ColourPicture picture = wavy({is_signed, false, false}, false);
        const std::vector<dvec3> before = normals_of_map(picture, look_at_normal_map(picture).reading);
        for (std::size_t i = 0; i < picture.colours.size(); i += 100)
            picture.colours[i] = i % 200 ? glm::vec3(-0.3f, 1.4f, -0.1f) : glm::vec3(0.5f, -1e-4f, 0.9f);
        const NormalMapLook look = look_at_normal_map(picture);
        CHECK(look.reading == NormalReading{is_signed, false, false});
        const std::vector<dvec3> after = normals_of_map(picture, look.reading);
        CHECK(after.back() == before.back());
    }
    // A surface that leans one way has no negative number where it is signed, and none near 0 where it is
    // not.
    const ColourPicture leaning{1, 1, {glm::vec3(0.5f, 0, 0.8660254f)}, 3, false};
    CHECK(look_at_normal_map(leaning).reading.is_signed);
    const ColourPicture encoded{1, 1, {glm::vec3(0.75f, 0.5f, 0.9330127f)}, 3, false};
    CHECK(look_at_normal_map(encoded).reading == NormalReading{});
}

TEST_CASE("normal map: what is no normal is left out and counted, and lengths are brought to 1") {
    ColourPicture picture{4,
                          2,
                          {{0.5f, 0.5f, 1},
                           {0.5f, 0.5f, 0.9f},
                           {0, 0, 0},
                           {0.5f, 0.5f, 0.5f},
                           {0.5f, 0.5f, 0},
                           {1, 0.5f, 0.5f},
                           {0.5f, 0.5f, 1},
                           {0.75f, 0.5f, 1}}};
    picture.alpha = {1, 1, 1, 1, 1, 1, 0, 0.5f};
    const NormalCounts counts = count_normals(picture, {});
    CHECK(counts.pixels == 8);
    CHECK(counts.empty == 3);
    CHECK(counts.not_facing_up == 2);
    CHECK(counts.resized == 2);
    CHECK(note_on(counts) ==
          "of 8 pixels 3 empty and left out, 2 not facing up and left out, 2 brought to length 1");
    const std::vector<dvec3> normals = normals_of_map(picture, {});
    REQUIRE(normals.size() == 3);
    for (const dvec3 n : normals) CHECK(glm::length(n) == doctest::Approx(1));
    CHECK(glm::length(normals[2] - glm::normalize(dvec3(0.5, 0, 1))) < 1e-6);
    CHECK(note_on(count_normals({1, 1, {{0.5f, 0.5f, 1}}}, {})).empty());
}

TEST_CASE("normal map: heights are slopes across their lines, of any sign") {
    // Rising to the right, with a jump where it begins anew.
    for (const float begin : {0.0f, -3.0f}) {
        ColourPicture ramp{8, 8, {}};
        for (int i = 0; i < 64; ++i) ramp.colours.push_back(glm::vec3(begin + static_cast<float>(i % 8) / 8));
        const dvec3 n = normals_of_heights(ramp, 1).at(8 * 4 + 4);
        CHECK(n.x == doctest::Approx(-1 / std::numbers::sqrt2));
        CHECK(n.y == 0);
        CHECK(normals_of_heights(ramp, -1).at(8 * 4 + 4) == dvec3(-n.x, n.y, n.z));  // hollows for hills
        CHECK(normals_of_heights(ramp, 0).at(8 * 4 + 4) == dvec3(0, 0, 1));
        ramp.channels = 2;
        for (glm::vec3& colour : ramp.colours) colour.z = 0;
        CHECK(normals_of_heights(ramp, 1).at(8 * 4 + 4) == n);
    }
}

TEST_CASE("normal map: heights keep their 16 bits") {
    const test::TemporaryFolder folder;
    std::string text = "P2 8 8 65535\n";
    for (int i = 0; i < 64; ++i) text += std::to_string(30000 + 3 * (i % 8)) + "\n";
    std::ofstream(folder.path() / "ramp.pgm") << text;
    const ColourPicture picture = load_colours(folder.path() / "ramp.pgm");
    // A depth of 1000 widths: 3/65535 of it a pixel, which is an eighth of the width.
    const double slope = 1000 * 8 * 3 / 65535.0;
    CHECK(normals_of_heights(picture, 1000).at(8 * 4 + 4).x ==
          doctest::Approx(-slope / std::hypot(1, slope)).epsilon(0.01));
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
