// A clear coat over any p: what the file holds, what a design without it pays, and that the physics holds.
#include <doctest/doctest.h>

#include <cmath>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/bake/coat_lobe.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/model/spectral/thin_film.h"
#include "core/verify/sampling_density.h"
#include "tests/core/cheap.h"
#include "tests/core/designs.h"
#include "tests/core/integrated.h"
#include "tests/core/reciprocity.h"
#include "tests/core/tinted_designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using Shader = Shading<double>;

Design coated(Design design, ClearCoat coat = {}) {
    design.coat = coat;
    return design;
}

// A mirror whose facets reflect this much at every angle.
Design mirror(Lobe lobe, double reflected) {
    Design design = design_of(std::move(lobe));
    design.fresnel = NoFresnel{};
    design.distribution.layers[0].tint = dvec3{reflected};
    if (reflected == 1) design.multibounce = RankOneMultibounce{};
    return design;
}

// Leaning, tinted, retro-reflective, with a diffuse term and bounces.
Design laden() {
    Design design = design_of(GgxLobe{0.3, 0.15}, 20, 40);
    design.distribution.layers[0].tint = crimson;
    design.fresnel = SchlickFresnel{dvec3{0.9, 0.6, 0.3}};
    design.diffuse = CoupledDiffuse{dvec3{0.8, 0.4, 0.2}};
    design.multibounce = RankOneMultibounce{};
    design.retro.weight = 0.3;
    return design;
}

dvec3 at_degrees(double theta) {
    const double angle = theta * std::numbers::pi / 180;
    return {std::sin(angle), 0, std::cos(angle)};
}

// The albedo by a walk between what lies beneath, whose BRDF is `beneath`, and a coat that lets `shading`'s
// part through, and its standard error. One walk's part that leaves at each bounce is its own expectation.
struct Walked {
    double mean, error;
};

Walked walked_albedo(const Brdf& beneath, const Shader& shading, dvec3 k1, int walks) {
    const auto leaves = [&](dvec3 k) {
        const dvec3 outside = shading.emerging(k);
        return outside.z > 0 ? 1 - shading.coat_albedo(std::sqrt(outside.z)) : 0.0;
    };
    Random random(3);
    double sum = 0, squares = 0;
    for (int i = 0; i < walks; ++i) {
        double left = 0;
        dvec3 k = shading.refracted(k1);
        double part = 1;
        for (int bounce = 0; bounce < 200 && part > 1e-4; ++bounce) {
            const auto sample = beneath.sample(k, random);
            if (!sample) break;
            part *= sample->weight.x;
            const double out = leaves(sample->k2);
            left += part * out;
            part *= 1 - out;
            k = Shader::turned(sample->k2);
        }
        sum += left;
        squares += left * left;
    }
    const double own = coat_albedo(shading, k1.z), mean = sum / walks;
    return {own + (1 - own) * mean, (1 - own) * std::sqrt((squares / walks - mean * mean) / walks)};
}

}  // namespace

TEST_SUITE_BEGIN("coat");

TEST_CASE("it stands in the file where there is one, and makes it one of version 2") {
    const Design plain = design_of(GgxLobe{0.2, 0.2});
    CHECK(design_json(plain, "/").find("coat") == std::string::npos);
    const Design lacquered = coated(plain, {0.1, 1.4, dvec3{0.9, 0.5, 0.2}});
    const std::string text = design_json(lacquered, "/");
    CHECK(text.find("\"nacre\": 2") != std::string::npos);
    CHECK(parse_design(text, "test.nacre", "/").coat == lacquered.coat);
}

TEST_CASE("a design without one pays nothing") {
    const Design plain = laden();
    const auto tables = bake(plain, {.quality = Quality::draft});
    CHECK(glsl_export(plain, *tables, "nacre").find("coat") == std::string::npos);
    CHECK(tables->shading.surface.tables.coat_rows == 0);
    CHECK(tables->coat_facets == nullptr);
}

TEST_CASE("it is reciprocal to the last bit") {
    for (const Design& design :
         {coated(laden()), coated(mirror(BeckmannLobe{0.1, 0.4}, 1), {0.2, 1.8, dvec3{0.5}})})
        check_reciprocity(bake(design, {.quality = Quality::draft}));
}

TEST_CASE("nothing is lost between it and what loses nothing, and nothing is gained") {
    for (const double alpha : {0.1, 0.5})
        for (const double roughness : {0.02, 0.3}) {
            const Brdf brdf(bake(coated(mirror(GgxLobe{alpha, alpha}, 1), {roughness, 1.5, dvec3{1}})));
            for (const double theta : {0.0, 30.0, 60.0, 80.0, 88.0}) {
                const dvec3 albedo = brdf.total_albedo(at_degrees(theta));
                CHECK(albedo.x > 1 - 4e-3);
                CHECK(albedo.x <= 1 + 1e-6);
            }
        }
}

TEST_CASE("the albedo of its tables is that of the BRDF") {
    const Design designs[] = {coated(laden(), {0.2, 1.5, dvec3{0.9, 0.7, 0.5}}),
                              coated(mirror(GgxLobe{0.4, 0.2}, 0.7), {0.3, 1.4, dvec3{1}})};
    for (const Design& design : designs) {
        const Brdf brdf(bake(design));
        for (const double theta : {0.0, 35.0, 70.0}) {
            const dvec3 k = at_degrees(theta), table = brdf.total_albedo(k);
            CHECK(apart(integrated(brdf, k, Term::total), table) < 1e-3);
            CHECK(std::max({table.x, table.y, table.z}) <= 1);
            dvec3 sum{0};
            for (const Term term : {Term::specular, Term::multibounce, Term::diffuse, Term::coat})
                sum += brdf.evaluate(k, at_degrees(-30), term);
            CHECK(apart(sum, brdf.evaluate(k, at_degrees(-30))) < 1e-12);
        }
    }
}

TEST_CASE("a random walk between it and what lies beneath gives the same albedo") {
    const int walks = cheap ? 2000 : 20000;
    for (const double alpha : {0.05, 0.2, 0.5})
        for (const double reflected : {1.0, 0.7}) {
            const Design bare = mirror(GgxLobe{alpha, alpha}, reflected);
            const Brdf beneath(bake(bare)), whole(bake(coated(bare)));
            for (const double theta : {0.0, 40.0, 60.0, 80.0}) {
                const dvec3 k = at_degrees(theta);
                const Walked walked = walked_albedo(beneath, whole.tables().shading, k, walks);
                CAPTURE(alpha);
                CAPTURE(reflected);
                CAPTURE(theta);
                CHECK(std::fabs(whole.total_albedo(k).x - walked.mean) < 0.005 + 4 * walked.error);
            }
        }
}

TEST_CASE("its own highlight keeps less than it gets, and nearly all on edge") {
    const auto tables = bake(coated(mirror(GgxLobe{0.2, 0.2}, 1), {0.02, 1.5, dvec3{1}}));
    CHECK(coat_albedo(tables->shading, 1) == doctest::Approx(0.04).epsilon(1e-3));
    CHECK(coat_albedo(tables->shading, 0.5) ==
          doctest::Approx(Shader::dielectric_reflectance(1.5, 0.5)).epsilon(0.01));
    for (int i = 1; i <= 40; ++i) {
        const double cosine = i / 40.0;
        CHECK(coat_albedo(tables->shading, cosine) <= 1);
        CHECK(std::fabs(coat_albedo(tables->shading, cosine) -
                        tables->shading.coat_albedo(std::sqrt(cosine))) < 1e-3);
    }
}

TEST_CASE("its colour is what is left of light that goes straight down and up") {
    const dvec3 colour{0.8, 0.4, 0.1};
    const Brdf clear(bake(coated(mirror(GgxLobe{0.01, 0.01}, 0.7))));
    const Brdf stained(bake(coated(mirror(GgxLobe{0.01, 0.01}, 0.7), {0.05, 1.5, colour})));
    const dvec3 n{0, 0, 1};
    const dvec3 part = stained.evaluate(n, n, Term::specular) / clear.evaluate(n, n, Term::specular);
    CHECK(apart(part, colour) < 1e-6);
}

TEST_CASE("what lies in it reflects less than in air") {
    for (const double ior : {1.3, 1.6, 2.4}) {
        const double f0 = Shader::dielectric_reflectance(ior, 1);
        CHECK(reflectance_beneath(dvec3{f0}, 1.5).x ==
              doctest::Approx(Shader::dielectric_reflectance(ior / 1.5, 1)).epsilon(1e-9));
        for (const double cosine : {1.0, 0.7, 0.3, 0.0})
            CHECK(film_reflectance({}, ior, 550, cosine, 1.5) ==
                  doctest::Approx(Shader::dielectric_reflectance(ior / 1.5, std::fmax(cosine, 1e-7)))
                      .epsilon(1e-6));
    }
    // Lacquer on lacquer is no border; from a denser medium all is reflected beyond the critical angle.
    CHECK(Shader::dielectric_reflectance(1.5 / 1.5, 0.4) == 0);
    CHECK(Shader::dielectric_reflectance(1 / 1.5, 0.7) == 1);
    const Brdf brdf(bake(coated([] {
        Design glass = design_of(GgxLobe{0.2, 0.2});
        glass.fresnel = DielectricFresnel{1.5};
        return glass;
    }())));
    CHECK(brdf.evaluate({0, 0, 1}, {0, 0, 1}, Term::specular) == dvec3{0});
}

TEST_CASE("samples come as densely as the pdf says, and their weights add up to the albedo") {
    for (const Design& design :
         {coated(laden()), coated(mirror(BeckmannLobe{0.1, 0.4}, 0.7), {0.2, 1.5, dvec3{1}})}) {
        const auto tables = bake(design);
        CHECK(measure_sampling_density(tables, {}, {}, cheap ? 1 : 4).surprise < 6);
        const Brdf brdf(tables);
        Random random(5);
        const dvec3 k = at_degrees(50);
        dvec3 sum{0};
        constexpr int count = 40000;
        for (int i = 0; i < count; ++i)
            if (const auto sample = brdf.sample(k, random)) sum += sample->weight;
        CHECK(apart(sum / double{count}, brdf.total_albedo(k)) < 0.02);
    }
}

TEST_SUITE_END();
