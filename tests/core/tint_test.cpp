// Layers with tints: what the file holds, what a design without them pays, and that the physics holds.
#include "core/model/tint.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/bake/baker.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/verify/physics_check.h"
#include "core/verify/reference.h"
#include "tests/core/integrated.h"
#include "tests/core/random_directions.h"
#include "tests/core/reciprocity.h"
#include "tests/core/tinted_designs.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

constexpr dvec3 white{1};

Design parse(const std::string& text) { return parse_design(text, "test.nacre", "/"); }

const dvec3 probes[] = {{0, 0, 1}, polar(0.8, 0.4), polar(0.5, 3.0), polar(0.2, 1.3), polar(0.1, 2.8)};

// Every Fresnel model and visibility with a diffuse term that reads R.
std::vector<Design> velvets() {
    std::vector<Design> all;
    for (std::size_t i = 0; i < KindSet<Fresnel>::count; ++i) {
        Design design = velvet();
        design.fresnel = KindSet<Fresnel>::made(i);
        design.shadowing.model = KindSet<MaskingModel>::made(i % KindSet<MaskingModel>::count);
        design.diffuse = i % 2 == 0 ? Diffuse{CoupledDiffuse{white}} : Diffuse{MetalDiffuse{}};
        all.push_back(design);
    }
    return all;
}

}  // namespace

TEST_SUITE_BEGIN("tint");

TEST_CASE("a tint stands in the file where it is not 1, and makes it one of version 2") {
    const Design plain = velvet_of(white, white);
    CHECK(design_json(plain, "/").find("tint") == std::string::npos);
    CHECK(version_of(plain) == 1);
    Design design = velvet_of(white, midnight);
    design.distribution.layers[1].enabled = false;
    CHECK(version_of(design) == 2);
    CHECK(design_json(design, "/").find("\"tint\": [0.03, 0.04, 0.3]") != std::string::npos);
    CHECK(parse(design_json(design, "/")) == design);
    const auto refusal = [](const std::string& value) {
        return user_error_of(
            [&] { parse("{\"nacre\": 2, \"distribution\": {\"layers\": [{\"tint\": " + value + "}]}}"); });
    };
    for (const char* wrong : {"1", "[1, 1]", "[1, 1, 1.5]", "[-0.1, 1, 1]"})
        CHECK(refusal(wrong).find(": distribution.layers[0].tint") != std::string::npos);
}

TEST_CASE("layers without facets do not count among the tints") {
    Design design = velvet_of(crimson, midnight);
    CHECK(tint_of(design.distribution) == Tint::varied);
    CHECK(apart(mean_tint(design.distribution), 0.5 * (crimson + midnight)) < 1e-15);
    design.distribution.layers[0].weight = 0;
    CHECK(tint_of(design.distribution) == Tint::shared);
    CHECK(mean_tint(design.distribution) == midnight);
    CHECK(tint_of(velvet_of(white, white).distribution) == Tint::none);
    design.distribution.layers = {Layer{}};
    CHECK(mean_tint(design.distribution) == white);
}

TEST_CASE("a mirror plane that changes the tints is none of R") {
    const auto symmetry = [](dvec3 one, dvec3 other) {
        return find_symmetry(velvet_of(one, other).distribution).symmetry;
    };
    CHECK(symmetry(white, white) == Symmetry::quarter);
    CHECK(symmetry(crimson, crimson) == Symmetry::quarter);
    CHECK(symmetry(crimson, midnight) == Symmetry::half);
}

TEST_CASE("the albedo of each colour is the integral of the BRDF") {
    for (const Design& design : velvets()) {
        CAPTURE(kind_name(design.fresnel));
        const Brdf brdf(bake(design));
        const Shading<double>& shading = brdf.tables().shading;
        for (const dvec3 k : probes) {
            CHECK(apart(brdf.albedo(k), integrated(brdf, k, Term::specular)) < 2e-3);
            // Two of whose colours are red and blue in turn.
            const dvec3 whole = shading.total_albedo(shading.direction(k));
            CHECK(apart(whole, integrated(brdf, k, Term::total)) < 2e-3);
            if (std::holds_alternative<CoupledDiffuse>(design.diffuse)) CHECK(apart(whole, white) < 1e-12);
        }
    }
}

TEST_CASE("each side of the velvet shows its own colour") {
    const Brdf brdf(bake(velvet()));
    const dvec3 right = brdf.evaluate(polar(0.7, 0.1), polar(0.7, -0.1)),
                left = brdf.evaluate(polar(0.7, pi + 0.1), polar(0.7, pi - 0.1));
    CHECK(right.x > 3 * right.z);
    CHECK(left.z > 3 * left.x);
}

TEST_CASE("exact R is that of the tables, in every colour") {
    for (const Design& design : velvets()) {
        CAPTURE(kind_name(design.fresnel));
        const auto tables = bake(design);
        const Reference reference(design);
        for (const dvec3 k : {probes[1], probes[3]}) {
            const AlbedoValues exact = reference.albedo(k);
            CHECK(apart(reference.design_albedo(exact), Brdf(tables).albedo(k)) < 1.5e-3);
            CHECK(albedo_error(tables->shading, k, exact, tables->needs.fresnel_tables) < 1.5e-3);
        }
    }
}

TEST_CASE("reciprocity to the last bit, in double, in float and side by side") {
    for (const Design& design : velvets()) check_reciprocity(bake(design, {.quality = Quality::draft}));
}

TEST_CASE("a tint that all layers share is a factor on the tables of the design without it") {
    for (const Fresnel& fresnel :
         {Fresnel{SchlickFresnel{}}, Fresnel{ConductorFresnel{}}, Fresnel{NoFresnel{}}}) {
        const auto with_fresnel = [&](Design design) {
            design.fresnel = fresnel;
            design.diffuse = CoupledDiffuse{white};
            return design;
        };
        const auto plain = bake(with_fresnel(velvet_of(white, white)));
        const auto shared = bake(with_fresnel(velvet_of(crimson, crimson)));
        CHECK(shared->data == plain->data);
        const Brdf one(plain), red(shared);
        // As if each layer had a tint of its own.
        const Brdf varied(bake(with_fresnel(velvet_of(crimson, crimson * (1 - 1e-9)))));
        for (const dvec3 k : probes) {
            CHECK(apart(red.albedo(k), crimson * one.albedo(k)) < 1e-15);
            CHECK(apart(red.albedo(k), varied.albedo(k)) < 2e-3);
            CHECK(apart(integrated(red, k, Term::total), white) < 2e-3);
        }
        CHECK(apart(red.tables().shading.surface.coupling, varied.tables().shading.surface.coupling) < 1e-3);
    }
}

TEST_CASE("black facets leave the diffuse term alone, and no metal") {
    Design design = velvet_of(dvec3{0}, dvec3{0});
    design.diffuse = CoupledDiffuse{white};
    const Brdf matt(bake(design));
    CHECK(matt.evaluate(probes[1], probes[2], Term::specular) == dvec3{0});
    CHECK(apart(matt.evaluate(probes[1], probes[2]), white / pi) < 1e-9);
    design.diffuse = MetalDiffuse{};
    CHECK(Brdf(bake(design)).evaluate(probes[1], probes[2]) == dvec3{0});
}

TEST_CASE("the physics of a tinted design holds, samples and pdf included") {
    Design design = velvet();
    design.diffuse = CoupledDiffuse{white};
    for (const auto& check : check_physics(design).checks)
        CHECK_MESSAGE(check.verdict != Verdict::fail, check.name, " ", check.figure);
}

TEST_CASE("a change of tints bakes R alone where they differ, and nothing where all share one") {
    Baker baker;
    const auto follow = [&](Design design) {
        design.diffuse = CoupledDiffuse{white};
        const auto tables = baker.bake(design);
        const auto fresh = bake(design);
        CHECK(tables->data == fresh->data);
        CHECK(tables->shading.surface.coupling == fresh->shading.surface.coupling);
        CHECK(tables->shading.kinds == fresh->shading.kinds);
        for (int i = 0; i < 2; ++i) CHECK(tables->shading.layers[i].tint == fresh->shading.layers[i].tint);
        return std::pair{baker.area_origin(), baker.albedo_origin()};
    };
    constexpr TableOrigin rebuilt = TableOrigin::rebuilt, reused = TableOrigin::reused;
    CHECK(follow(velvet_of(white, white)) == std::pair{rebuilt, rebuilt});
    CHECK(follow(velvet_of(crimson, crimson)) == std::pair{reused, reused});
    CHECK(follow(velvet_of(crimson, midnight)) == std::pair{rebuilt, rebuilt});  // less symmetry
    CHECK(follow(velvet_of(white, midnight)) == std::pair{reused, rebuilt});
    CHECK(follow(velvet_of(midnight, midnight)) == std::pair{rebuilt, rebuilt});
}

TEST_SUITE_END();
