// The intensity of the specular term: a factor on it, applied last.
#include <doctest/doctest.h>

#include <cmath>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/bake/brdf_pairs.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/formats/table_files.h"
#include "core/formats/table_manifest.h"
#include "core/model/float_shading.h"
#include "core/verify/physics_check.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design coated(double intensity) {
    Design design = design_of(GgxLobe{0.3, 0.3});
    design.diffuse = CoupledDiffuse{dvec3{0.9, 0.5, 0.1}};
    design.specular.intensity = intensity;
    return design;
}

Design parse(const std::string& text) { return parse_design(text, "test.nacre", "/"); }

const PhysicsCheck* intensity_check(const PhysicsReport& report) {
    for (const PhysicsCheck& check : report.checks)
        if (check.name == "intensity") return &check;
    return nullptr;
}

std::string manifest_of(const Design& design) {
    const auto tables = bake(design);
    return table_manifest(design, *tables, table_pictures(*tables), tables->errors);
}

}  // namespace

TEST_CASE("intensity: it stands in the file where it is not 1, and makes it one of version 2") {
    CHECK(design_json(coated(1), "/").find("specular") == std::string::npos);
    CHECK(design_json(coated(1), "/").find("\"nacre\": 1,") != std::string::npos);
    const std::string text = design_json(coated(2.5), "/");
    CHECK(text.find("\"nacre\": 2,") != std::string::npos);
    CHECK(parse(text) == coated(2.5));
    CHECK(parse("{\"nacre\": 2}") == Design{});
    CHECK(parse("{\"nacre\": 2, \"specular\": {}}") == Design{});
    for (const double intensity : {0.0, 4.0})
        CHECK(parse(design_json(coated(intensity), "/")) == coated(intensity));
    const auto refusal = [](const std::string& key) {
        return user_error_of([&] { parse("{\"nacre\": 2, \"specular\": {" + key + "}}"); });
    };
    CHECK(refusal("\"intensity\": 4.1").find(": specular.intensity: ") != std::string::npos);
    CHECK(refusal("\"intensity\": -0.1").find(": specular.intensity: ") != std::string::npos);
    CHECK(refusal("\"colour\": 1").find(": specular.colour: ") != std::string::npos);
}

TEST_CASE("intensity: everything specular follows it, and nothing else") {
    const auto plain = bake(coated(1)), bright = bake(coated(2.5));
    CHECK(plain->data == bright->data);
    CHECK(plain->shading.surface.coupling == bright->shading.surface.coupling);
    const Brdf one(plain), more(bright);
    Reference exact(coated(1)), exactly_more(coated(2.5));
    exact.prepare_coupling();
    exactly_more.prepare_coupling();
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        const dvec3 a = random_direction(random), b = random_direction(random);
        const dvec3 specular = one.evaluate(a, b, Term::specular),
                    diffuse = one.evaluate(a, b, Term::diffuse);
        CHECK(more.evaluate(a, b, Term::specular) == 2.5 * specular);
        CHECK(more.evaluate(a, b, Term::diffuse) == diffuse);
        CHECK(more.evaluate(a, b) == more.evaluate(b, a));
        CHECK(more.albedo(a) == one.albedo(a));
        const auto exact_term = [&](const Reference& of, Term term) {
            return brdf_term(of.shading(), of.direction(a), of.direction(b), term);
        };
        if (i > 5) continue;
        CHECK(exact_term(exactly_more, Term::specular) == 2.5 * exact_term(exact, Term::specular));
        CHECK(exact_term(exactly_more, Term::diffuse) == exact_term(exact, Term::diffuse));
    }
}

TEST_CASE("intensity: many directions at once, and what samples weigh") {
    const Brdf brdf(bake(coated(3)));
    const Shading<float> shading = in_float(brdf.tables().shading);
    Random random(5);
    std::vector<glm::vec3> k1, k2;
    for (int i = 0; i < 200; ++i) {
        const dvec3 a = random_direction(random);
        const auto sample = brdf.sample(a, random);
        if (!sample) continue;
        const dvec3 rho = brdf.evaluate(a, sample->k2);
        for (int c = 0; c < 3; ++c)
            CHECK(sample->weight[c] == doctest::Approx(rho[c] * sample->k2.z / sample->pdf).epsilon(1e-9));
        k1.emplace_back(a);
        k2.emplace_back(sample->k2);
    }
    std::vector<glm::vec3> rho(k1.size());
    evaluate_pairs(shading, k1, k2, rho);
    for (std::size_t i = 0; i < rho.size(); ++i) {
        const glm::vec3 expected = shading.brdf(k1[i], k2[i]);
        for (int c = 0; c < 3; ++c) CHECK(rho[i][c] == doctest::Approx(expected[c]).epsilon(2e-5));
    }
}

TEST_CASE("intensity: exports carry it, and without it they are what they were") {
    const auto with = [](double intensity) {
        return glsl_export(coated(intensity), *bake(coated(intensity)));
    };
    CHECK(with(1).find(" 0.0, 1.0, vec3(0.9, 0.5, 0.1)") != std::string::npos);
    CHECK(with(2).find(" 0.0, 2.0, vec3(0.9, 0.5, 0.1)") != std::string::npos);
    CHECK(manifest_of(coated(1)).find("intensity") == std::string::npos);
    const std::string manifest = manifest_of(coated(2));
    CHECK(manifest.find("\"specular = specular_intensity p(h) F V/4\"") != std::string::npos);
    CHECK(manifest.find("\"validity\": \"specular intensity 2 creates energy\"") != std::string::npos);
    CHECK(manifest_of(coated(0.5)).find("validity") == std::string::npos);
}

TEST_CASE("intensity: check says in words that it creates energy, and calls no table wrong") {
    // Dark facets and no diffuse term: four times as bright sends back less than all.
    Design dark = design_of(GgxLobe{0.3, 0.3});
    dark.specular.intensity = 4;
    Design mirror = coated(2);
    mirror.fresnel = NoFresnel{};
    for (const bool creates : {false, true}) {
        const PhysicsReport report = check_physics(creates ? mirror : dark);
        const PhysicsCheck* check = intensity_check(report);
        REQUIRE(check);
        CHECK(check->text.find("creates energy") != std::string::npos);
        CHECK((check->figure > 1) == creates);
        CHECK(check->verdict == (creates ? Verdict::fail : Verdict::note));
        CHECK(report.passed() == !creates);
        for (const PhysicsCheck& other : report.checks)
            if (&other != check) CHECK_MESSAGE(other.verdict != Verdict::fail, other.name);
    }
    CHECK_FALSE(intensity_check(check_physics(coated(0.5))));
}
