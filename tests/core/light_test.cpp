// Environment maps, the procedural ones, and the order that directions are drawn
// in.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>

#include "core/formats/environment_file.h"
#include "core/image/image_file.h"
#include "core/image/picture.h"
#include "core/light/environment.h"
#include "core/light/facet_order.h"
#include "core/light/hilbert.h"
#include "core/light/procedural.h"
#include "core/light/sky.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;
using std::numbers::pi;

namespace {

dvec3 anywhere(Random& random) {
    dvec3 d = random_direction(random);
    if (uniform_random(random) < 0.5) d.z = -d.z;
    return d;
}

// Mean of (d.k)+ over the directions of an order.
double seen(const DirectionOrder& order, dvec3 k) {
    double sum = 0;
    for (std::size_t i = order_nodes; i < order.texels.size(); ++i)
        sum += std::fmax(glm::dot(k, dvec3(order.texels[i])), 0.0);
    return sum / order_count;
}

// Of a picture on a surface that faces `n`.
dvec3 irradiance(const LatLong& picture, dvec3 n) {
    dvec3 sum{0};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const glm::dvec2 place((column + 0.5) / picture.width, (row + 0.5) / picture.height);
            sum += radiance_at(picture, place) * texel_solid_angle(picture, row) *
                   std::fmax(glm::dot(n, lat_long_direction(place)), 0.0);
        }
    return sum;
}

}  // namespace

TEST_SUITE_BEGIN("light");

TEST_CASE("directions and places are each other's inverse, unmirrored") {
    CHECK(glm::length(lat_long_direction({0.5, 0.5}) - dvec3(0, 0, -1)) < 1e-15);
    CHECK(glm::length(lat_long_direction({0.75, 0.5}) - dvec3(1, 0, 0)) < 1e-15);
    CHECK(glm::length(lat_long_direction({0.3, 0}) - dvec3(0, 1, 0)) < 1e-15);
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const dvec3 d = anywhere(random);
        CHECK(glm::length(lat_long_direction(lat_long_place(d)) - d) < 1e-12);
    }
}

TEST_CASE("texels share out the sphere, and the look-up goes round without a seam") {
    LatLong picture{8, 4, {}};
    for (int i = 0; i < 32; ++i) picture.radiance.emplace_back(static_cast<float>(i));
    double sum = 0;
    for (int row = 0; row < 4; ++row) sum += 8 * texel_solid_angle(picture, row);
    CHECK(sum == doctest::Approx(4 * pi).epsilon(1e-12));
    CHECK(radiance_at(picture, {2.5 / 8, 1.5 / 4}).x == doctest::Approx(10));
    CHECK(radiance_at(picture, {3.0 / 8, 2.0 / 4}).x == doctest::Approx((10 + 11 + 18 + 19) / 4.0));
    CHECK(radiance_at(picture, {0, 0.5 / 4}).x == doctest::Approx(3.5));
    CHECK(radiance_at(picture, {1, 0.5 / 4}).x == doctest::Approx(3.5));
    CHECK(radiance_at(picture, {0.5 / 8, 1}).x == doctest::Approx(24));
}

TEST_CASE("Hilbert's curve meets every cell once and steps to a neighbour") {
    std::set<std::pair<int, int>> met;
    glm::ivec2 last = hilbert_cell(0, 16);
    for (int i = 0; i < 256; ++i) {
        const glm::ivec2 cell = hilbert_cell(i, 16);
        met.insert({cell.x, cell.y});
        if (i > 0) CHECK(std::abs(cell.x - last.x) + std::abs(cell.y - last.y) == 1);
        last = cell;
    }
    CHECK(met.size() == 256);
}

TEST_CASE("ordered facets are p: their projected area is its own") {
    Random random(7);
    const Design designs[] = {
        design_of(GgxLobe{0.4, 0.1}, 20, 30), design_of(GaussianLobe{0.001, 1}),
        with_layer(design_of(BeckmannLobe{0.05, 0.05}), UniformLobe{UniformDomain::sphere}, 0.2),
        slanted_velvet(1, true)};
    for (const Design& design : designs) {
        const FacetDistribution p(design.distribution);
        const DirectionOrder order = order_facets(p, 256);
        REQUIRE(order.texels.size() == static_cast<std::size_t>(order_nodes + order_count));
        for (int i = 0; i < 12; ++i) {
            const dvec3 k = random_direction(random);
            CHECK(seen(order, k) == doctest::Approx(p.projected_area(k)).epsilon(3e-3));
        }
    }
}

TEST_CASE("a range's node is the mean of its directions and their spread") {
    const DirectionOrder order =
        order_facets(FacetDistribution(design_of(GgxLobe{0.3, 0.3}).distribution), 128);
    for (const int range : {0, 3, 17, 1023}) {
        const int first = order_nodes + range * order_leaf_size;
        dvec3 mean{0};
        double squares = 0;
        for (int i = 0; i < order_leaf_size; ++i)
            mean += dvec3(order.texels[static_cast<std::size_t>(first + i)]) / double(order_leaf_size);
        for (int i = 0; i < order_leaf_size; ++i) {
            const dvec3 off = dvec3(order.texels[static_cast<std::size_t>(first + i)]) - mean;
            squares += glm::dot(off, off) / order_leaf_size;
        }
        const glm::vec4 node = order.texels[static_cast<std::size_t>(order_nodes - order_leaves + range)];
        CHECK(glm::length(dvec3(node) - mean) < 1e-6);
        CHECK(static_cast<double>(node.w) == doctest::Approx(std::sqrt(squares)).epsilon(1e-3));
    }
}

TEST_CASE("ordered light is the picture: what a surface sees of it is its irradiance") {
    const LatLong picture = *procedural_environment("sky", 256);
    const auto environment = make_environment("sky", picture);
    Random random(9);
    for (int i = 0; i < 8; ++i) {
        const dvec3 n = anywhere(random), light = irradiance(picture, n);
        CHECK(environment->brightness * seen(environment->light, n) ==
              doctest::Approx((light.x + light.y + light.z) / 3).epsilon(5e-3));
    }
}

TEST_CASE("light is drawn from what the picture holds, and from nothing where there is none") {
    LatLong picture{64, 32, std::vector<glm::vec3>(64 * 32, glm::vec3(0))};
    picture.radiance[10 * 64 + 20] = {3, 2, 1};
    picture.radiance[20 * 64 + 63] = {0, 0, 5};
    const auto environment = make_environment("two lamps", picture);
    double sum = 0;
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 64; ++column) {
            const glm::dvec2 place((column + 0.5) / 64, (row + 0.5) / 32);
            sum += environment->light_density(radiance_at(picture, place)) * texel_solid_angle(picture, row);
        }
    CHECK(sum == doctest::Approx(1).epsilon(0.01));
    for (std::size_t i = order_nodes; i < environment->light.texels.size(); i += 997) {
        const glm::dvec2 place = lat_long_place(glm::normalize(dvec3(environment->light.texels[i])));
        CHECK(glm::length(radiance_at(picture, place)) > 0);
    }
    const auto dark = make_environment("night", {16, 8, std::vector<glm::vec3>(128, glm::vec3(0))});
    CHECK(dark->light_density(dvec3(0)) == 0);
    CHECK(seen(dark->light, {0, 1, 0}) == doctest::Approx(0.25).epsilon(0.03));
}

TEST_CASE("the procedural environments hold what their names say") {
    for (const ProceduralEnvironment* known : procedural_environments()) {
        const auto picture = procedural_environment(known->name, 64);
        REQUIRE(picture);
        CHECK(picture->radiance.size() == 64 * 32);
        for (const glm::vec3& light : picture->radiance) CHECK(light.x + light.y + light.z > 0);
    }
    CHECK(!procedural_environment("moonlight"));
    const LatLong octants = *procedural_environment("octants", 64);
    CHECK(radiance_at(octants, lat_long_place(glm::normalize(dvec3(1, -1, -1)))) ==
          dvec3(glm::vec3(1, 0.1, 0.1)));
    CHECK(radiance_at(octants, lat_long_place(glm::normalize(dvec3(-1, 1, 1)))) ==
          dvec3(glm::vec3(0.1, 1, 1)));
    CHECK(irradiance(*procedural_environment("furnace", 256), {0.6, 0, 0.8}).y ==
          doctest::Approx(pi).epsilon(1e-3));
}

TEST_CASE("the sky is Preetham's, and its sun shines as much on any raster") {
    // Appendix A.2 by hand for a sun 45 degrees high and turbidity 3: chi = (4/9 - 3/120)(pi - pi/2) =
    // 0.65886, Y = (4.0453 3 - 4.9710) tan(chi) - 0.2155 3 + 2.4192 = 7.1649 0.77433 + 1.7727 = 7.3207
    // kcd/m^2.
    const ClearSky sky(glm::normalize(dvec3(0, 1, 1)), 3);
    const dvec3 zenith = sky.radiance({0, 1, 0});
    CHECK(0.2126 * zenith.x + 0.7152 * zenith.y + 0.0722 * zenith.z == doctest::Approx(7.3207).epsilon(2e-3));
    CHECK(zenith.z > zenith.x);
    CHECK(glm::length(sky.radiance(glm::normalize(dvec3(0.1, 1, 1)))) >
          2 * glm::length(sky.radiance(glm::normalize(dvec3(0.1, 1, -1)))));
    const dvec3 n = glm::normalize(dvec3(-0.5, 0.6, 0.6));
    const dvec3 coarse = irradiance(*procedural_environment("sky", 256), n);
    const dvec3 fine = irradiance(*procedural_environment("sky", 1024), n);
    for (int c = 0; c < 3; ++c) CHECK(coarse[c] == doctest::Approx(fine[c]).epsilon(0.01));
}

TEST_CASE("an environment map is read as it is, and what cannot be used is one line") {
    const TemporaryFolder folder;
    std::vector<float> values;
    for (int i = 0; i < 8 * 4; ++i) values.insert(values.end(), {0.5f * static_cast<float>(i), 1, 2000});
    const auto file = folder.path() / "sunny.exr";
    write_image(file, {8, 4}, values);
    const LatLong light = load_lat_long(file);
    CHECK(light.width == 8);
    CHECK(light.radiance[11] == glm::vec3(5.5f, 1, 2000));
    CHECK(load_environment(file.string())->name == file.string());

    const auto encoded = folder.path() / "grey.png";
    write_image(encoded, {4, 2}, std::vector<float>(24, 188 / 255.0f));
    CHECK(load_lat_long(encoded).radiance[3].y == doctest::Approx(0.5029).epsilon(1e-3));

    const auto refused = [&](std::vector<float> rgb, glm::ivec2 size, const char* why) {
        write_image(file, size, rgb);
        const std::string line = user_error_of([&] { load_environment(file.string()); });
        CHECK(line.find(why) != std::string::npos);
    };
    refused(std::vector<float>(75, 1), {5, 5}, "5 x 5 pixels, must be twice as wide as high");
    values[30] = std::numeric_limits<float>::quiet_NaN();
    refused(values, {8, 4}, "pixel (2, 1) from the top left is nan, must be finite");
    CHECK(user_error_of([] { load_environment("/nowhere/sky.exr"); }).starts_with("/nowhere/sky.exr: "));
}

TEST_CASE("a large picture is averaged down") {
    const TemporaryFolder folder;
    std::vector<float> values(2560 * 1280 * 3, 1);
    const auto file = folder.path() / "large.exr";
    write_image(file, {2560, 1280}, values);
    const LatLong light = load_lat_long(file);
    CHECK(light.width == 2048);
    CHECK(light.radiance.size() == 2048 * 1024);
    CHECK(light.radiance[1000] == glm::vec3(1));
    CHECK(light.radiance.back() == glm::vec3(1));
}

TEST_SUITE_END();
