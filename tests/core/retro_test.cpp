// Retro-reflection over any p: what the file holds, what a design without it pays, and that the physics
// holds.
#include "core/model/retro.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/bake/baker.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/formats/table_files.h"
#include "core/formats/table_manifest.h"
#include "core/shading/shader_variant.h"
#include "core/verify/reference.h"
#include "tests/core/integrated.h"
#include "tests/core/reciprocity.h"
#include "tests/core/retro_designs.h"
#include "tests/core/tinted_designs.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design parse(const std::string& text) { return parse_design(text, "test.nacre", "/"); }

// One of each masking, Fresnel and diffuse model that asks something else of R, one of them with tints.
std::vector<Design> designs() {
    std::vector<Design> all = {lopsided(0.6)};
    Design metal = lopsided(1);
    metal.fresnel = ConductorFresnel{};
    metal.diffuse = MetalDiffuse{};
    metal.shadowing.model = SmithCorrelatedMasking{};
    all.push_back(metal);
    Design tinted = lopsided(0.3);
    tinted.shadowing.model = CorrelatedMasking{};
    tinted.distribution.layers[0].tint = crimson;
    tinted.distribution.layers[1].tint = midnight;
    all.push_back(tinted);
    all.push_back(upright(0.5));
    return all;
}

std::string manifest_of(const Design& design, const Tables& tables) {
    return table_manifest(design, tables, table_pictures(tables), TableErrors{});
}

// Where bits are compared, no table need be good.
std::shared_ptr<const Tables> drafted(const Design& design) {
    return bake(design, {.quality = Quality::draft});
}

}  // namespace

TEST_SUITE_BEGIN("retro");

TEST_CASE("it stands in the file where it is above 0, and makes it one of version 2") {
    CHECK(design_json(upright(0), "/").find("retro") == std::string::npos);
    CHECK(version_of(upright(0)) == 1);
    const std::string text = design_json(upright(0.25), "/");
    CHECK(text.find("\"nacre\": 2,") != std::string::npos);
    CHECK(text.find("\"retro\": {\"weight\": 0.25}") != std::string::npos);
    for (const double weight : {1e-300, 0.25, 1.0})
        CHECK(parse(design_json(upright(weight), "/")) == upright(weight));
    CHECK(parse("{\"nacre\": 2, \"retro\": {}}") == Design{});
    const auto refusal = [](const std::string& key) {
        return user_error_of([&] { parse("{\"nacre\": 2, \"retro\": {" + key + "}}"); });
    };
    CHECK(refusal("\"weight\": 1.1").find(": retro.weight: ") != std::string::npos);
    CHECK(refusal("\"weight\": -0.1").find(": retro.weight: ") != std::string::npos);
    CHECK(refusal("\"colour\": 1").find(": retro.colour: ") != std::string::npos);
}

TEST_CASE("a design without it has the tables, shader and exports that it would have if it did not exist") {
    const Design plain = lopsided(0);
    const auto tables = drafted(plain), with = drafted(lopsided(0.5));
    CHECK(with->data == tables->data);
    CHECK(with->needs == tables->needs);
    for (const std::string& text : {glsl_export(plain, *tables), manifest_of(plain, *tables),
                                    fragment_shader(variant_of(tables->shading), "surface.frag"),
                                    fragment_shader(variant_of(tables->shading), "accumulate.frag")}) {
        CHECK(text.find("retro") == std::string::npos);
        CHECK(text.find("RETRO") == std::string::npos);
        CHECK(text.find("turned") == std::string::npos);
        CHECK(text.find("OR_ZERO") == std::string::npos);
    }
    CHECK(glsl_export(lopsided(0.5), *with).find("retro") != std::string::npos);
    CHECK(manifest_of(lopsided(0.5), *with).find("\"retro\": 0.5") != std::string::npos);
}

TEST_CASE("a baker keeps its tables where only the weight changes") {
    Baker baker;
    const BakeOptions draft{.quality = Quality::draft};
    const auto before = baker.bake(lopsided(0), draft), after = baker.bake(lopsided(0.5), draft);
    CHECK(after->data == before->data);
    CHECK(after->shading.surface.retro == 0.5);
    CHECK_FALSE(before->shading.kinds.retro);
    CHECK(baker.bake(lopsided(0), draft)->shading.kinds == before->shading.kinds);
}

TEST_CASE("the whole of it is the mean of both one-sided forms, to the last bit") {
    for (Design design : designs()) {
        design.diffuse = NoDiffuse{};
        Design without = design;
        without.retro.weight = 0;
        design.retro.weight = 1;
        const Brdf plain(drafted(without)), retro(drafted(design));
        Random random(2);
        for (int i = 0; i < 200; ++i) {
            const dvec3 a = random_direction(random), b = random_direction(random);
            const dvec3 there = plain.evaluate(a, turned(b)), here = plain.evaluate(turned(a), b);
            CHECK(retro.evaluate(a, b) == 0.5 * there + 0.5 * here);
        }
    }
}

TEST_CASE("a weight mixes: what is mirrored and what goes back add up to the specular term") {
    for (const double weight : {0.2, 0.7}) {
        const Brdf plain(drafted(lopsided(0))), mixed(drafted(lopsided(weight)));
        Random random(4);
        for (int i = 0; i < 100; ++i) {
            const dvec3 a = random_direction(random), b = random_direction(random);
            const dvec3 back = mixed.evaluate(a, b, Term::retro),
                        whole = mixed.evaluate(a, b, Term::specular);
            const dvec3 expected = (1 - weight) * plain.evaluate(a, b, Term::specular) + back;
            for (int c = 0; c < 3; ++c) CHECK(whole[c] == doctest::Approx(expected[c]).epsilon(1e-12));
            CHECK(plain.evaluate(a, b, Term::retro) == dvec3{0});
        }
    }
}

TEST_CASE("light goes back to where it came from, in the shape that a mirror would give it") {
    const Brdf mirror(bake(upright(0))), retro(bake(upright(1)));
    for (const dvec3 k1 : {polar(0.9, 0.3), polar(0.4, 2)}) {
        CHECK(retro.evaluate(k1, k1).y > 10 * retro.evaluate(k1, turned(k1)).y);
        for (const double phi : {0.0, 0.2, 1.0}) {
            const dvec3 k2 = polar(0.6, 1 + phi);
            CHECK(retro.evaluate(k1, k2).y ==
                  doctest::Approx(mirror.evaluate(k1, turned(k2)).y).epsilon(1e-12));
        }
    }
}

TEST_CASE("its albedo is the mean of R on both sides, by the BRDF and by the tables, and never above 1") {
    for (const Design& design : designs()) {
        Baker baker;
        const auto tables = baker.bake(design, {.albedo = true});
        const Brdf brdf(tables);
        Design without = design;
        without.retro.weight = 0;
        const Brdf plain(baker.bake(without, {.albedo = true}));
        const double part = 0.5 * design.retro.weight;
        for (const dvec3 k : {probes[0], probes[1], probes[3]}) {
            const dvec3 mean = (1 - part) * plain.albedo(k) + part * plain.albedo(turned(k));
            CHECK(apart(brdf.albedo(k), mean) < 1e-12);
            CHECK(apart(brdf.albedo(k), integrated(brdf, k, Term::specular)) < 1e-3);
            const dvec3 whole = tables->shading.total_albedo(tables->shading.direction(k));
            CHECK(apart(whole, integrated(brdf, k, Term::total)) < 1e-3);
            CHECK(std::max({whole.x, whole.y, whole.z}) <= 1 + 1e-3);
            if (std::holds_alternative<CoupledDiffuse>(design.diffuse)) CHECK(apart(whole, white) < 1e-12);
        }
    }
}

// Of the lopsided one without the constant of eq. 28, which takes hundreds of albedos.
TEST_CASE("what the tables answer is what adaptive integration answers") {
    for (const bool leaning : {true, false}) {
        Design design = leaning ? lopsided(0.6) : upright(0.5);
        if (!leaning) design.diffuse = CoupledDiffuse{white};
        Reference reference(design);
        if (!leaning) reference.prepare_coupling();
        const Brdf brdf(bake(design));
        const Shading<double>::Direction a = reference.direction(probes[1]),
                                         b = reference.direction(probes[2]);
        CHECK(apart(a.R, brdf.albedo(a.k)) < 1e-3);
        CHECK(apart(b.R, brdf.albedo(b.k)) < 1e-3);
        CHECK(a.turned_g == doctest::Approx(reference.projected_area(turned(a.k))).epsilon(1e-12));
        for (const Term term : {Term::specular, Term::retro, Term::diffuse, Term::total}) {
            if (leaning && (term == Term::diffuse || term == Term::total)) continue;
            const dvec3 exact = brdf_term(reference.shading(), a, b, term);
            CHECK(exact.y > 0);
            CHECK(apart(brdf.evaluate(a.k, b.k, term), exact) < 2e-3 * exact.x);
        }
    }
}

TEST_CASE("retro: reciprocity to the last bit, in double, in float and side by side") {
    for (const Design& design : designs()) check_reciprocity(drafted(design));
}

TEST_SUITE_END();
