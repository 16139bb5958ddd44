// MERL's format, by what its own readers do with an index.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/bake/brdf.h"
#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/formats/export_format.h"
#include "core/formats/merl_file.h"
#include "tests/core/cheap.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design preset(const char* name) {
    return load_design(std::string(NACRE_SOURCE_DIR "/presets/") + name + ".nacre");
}

double stored(const std::string& bytes, std::size_t index) {
    double value;
    REQUIRE(12 + 8 * index + 8 <= bytes.size());
    std::memcpy(&value, bytes.data() + 12 + 8 * index, 8);
    return value;
}

// The index that a reader of MERL's own code looks up for a pair of directions.
struct Bins {
    double theta_h, theta_d, phi_d;
};
Bins bins_of(dvec3 light, dvec3 view) {
    const double degrees = 180 / std::numbers::pi;
    const dvec3 h = glm::normalize(light + view);
    const double theta = std::acos(std::min(1.0, h.z)), phi = std::atan2(h.y, h.x);
    const auto about_z = [](dvec3 v, double a) {
        return dvec3(std::cos(a) * v.x - std::sin(a) * v.y, std::sin(a) * v.x + std::cos(a) * v.y, v.z);
    };
    const auto about_y = [](dvec3 v, double a) {
        return dvec3(std::cos(a) * v.x + std::sin(a) * v.z, v.y, std::cos(a) * v.z - std::sin(a) * v.x);
    };
    const dvec3 d = about_y(about_z(light, -phi), -theta);
    double phi_d = std::atan2(d.y, d.x) * degrees;
    if (phi_d < 0) phi_d += 180;
    return {90 * std::sqrt(theta * degrees / 90), std::acos(std::min(1.0, d.z)) * degrees, phi_d};
}

}  // namespace

TEST_CASE("MERL: a pair of directions stands where its readers look it up") {
    for (const auto& [h, d, phi] : {std::array{10.5, 20.5, 30.5}, {60.5, 3.5, 170.5}, {0.5, 70.5, 90.5}}) {
        const MerlPair pair = merl_pair(h, d, phi);
        CHECK(glm::length(pair.k1) == doctest::Approx(1));
        CHECK(glm::length(pair.k2) == doctest::Approx(1));
        const Bins bins = bins_of(pair.k1, pair.k2);
        CHECK(bins.theta_h == doctest::Approx(h).epsilon(1e-6));
        CHECK(bins.theta_d == doctest::Approx(d).epsilon(1e-6));
        CHECK(bins.phi_d == doctest::Approx(phi).epsilon(1e-6));
    }
}

TEST_CASE("MERL: the file holds the BRDF at its bins, scaled, and -1 below the horizon" *
          doctest::skip(cheap)) {
    const Design design = preset("copper");
    const ExportSettings settings;
    const std::string bytes = prepare_export(merl_format, design, settings, {}, {}).bytes();
    const std::string edges = prepare_export(merl_edge_format, design, settings, {}, {}).bytes();
    REQUIRE(bytes.size() == 34'992'012);
    REQUIRE(edges.size() == bytes.size());
    std::int32_t sizes[3];
    std::memcpy(sizes, bytes.data(), 12);
    CHECK(sizes[0] == 90);
    CHECK(sizes[1] == 90);
    CHECK(sizes[2] == 180);
    const Brdf brdf(bake(design));
    Random random(5);
    int above = 0, below = 0;
    for (int i = 0; i < 10000; ++i) {
        const int h = static_cast<int>(random() % 90), d = static_cast<int>(random() % 90),
                  phi = static_cast<int>(random() % 180);
        const std::size_t at = static_cast<std::size_t>(phi + 180 * (d + 90 * h));
        for (const auto& [file, part] : {std::pair{&bytes, 0.5}, {&edges, 0.0}}) {
            const MerlPair pair = merl_pair(h + part, d + part, phi + part);
            const bool both = pair.k1.z > 0 && pair.k2.z > 0;
            ++(both ? above : below);
            const dvec3 rho = brdf.evaluate(pair.k1, pair.k2);
            const double scale[] = {1500, 1500 / 1.15, 1500 / 1.66};
            for (int c = 0; c < 3; ++c) {
                const double expected = both ? rho[c] * scale[c] : -1;
                const double found = stored(*file, at + static_cast<std::size_t>(c) * 1'458'000);
                REQUIRE(std::abs(found - expected) <= 1e-6 * std::abs(expected));
            }
        }
    }
    CHECK(above > 5000);
    CHECK(below > 500);
}

TEST_CASE("MERL: an anisotropic design is refused by what it has") {
    CHECK_THROWS_WITH_AS(prepare_export(merl_format, preset("brushed-gold"), {}, {}, {}),
                         doctest::Contains("what the format cannot hold: anisotropic p"), UserError);
}
