// F82, what Fresnel models become of each other, and which of them is a table in the shader.
#include <doctest/doctest.h>

#include <cmath>

#include "core/shading/shader_variant.h"
#include "core/shading/surface.h"

using namespace nacre;
using glm::dvec3;

TEST_SUITE_BEGIN("fresnel models");

TEST_CASE("F82 is Schlick's curve but for a dip that is F82 times as high at 82 degrees") {
    const F82Fresnel model{{0.9, 0.5, 0.02}, {0.8, 1, 0}};
    const Reflectance f = reflectance_of(model), schlick = reflectance_of(SchlickFresnel{model.f0});
    for (int c = 0; c < 3; ++c) {
        CHECK(f(1)[c] == doctest::Approx(model.f0[c]).epsilon(1e-12));
        CHECK(std::fabs(f(1.0 / 7)[c] - model.f82[c] * schlick(1.0 / 7)[c]) < 1e-12);
        CHECK(f(0)[c] == doctest::Approx(1).epsilon(1e-12));
    }
    for (const double cosine : {0.9, 0.4, 0.1}) {
        CHECK(f(cosine).y == doctest::Approx(schlick(cosine).y).epsilon(1e-12));
        CHECK(f(cosine).z >= 0);
    }
    // The dip is deepest at 1/7.
    const auto dip = [&](double cosine) { return schlick(cosine).x - f(cosine).x; };
    CHECK(dip(1.0 / 7) > dip(1.0 / 7 + 1e-3));
    CHECK(dip(1.0 / 7) > dip(1.0 / 7 - 1e-3));
}

TEST_CASE("gold by Schlick becomes a conductor of its colour at every angle, as far as eta and k can") {
    for (const dvec3 gold : {dvec3{0.9999999, 0.7123, 0.298}, dvec3{0.95, 0.7, 0.3}}) {
        const Reflectance schlick = reflectance_of(SchlickFresnel{gold});
        const ConductorFresnel fitted = ConductorFresnel::of_reflectance(schlick);
        const Reflectance f = reflectance_of(fitted);
        for (int c = 0; c < 3; ++c) {
            CHECK(fitted.eta[c] < 3);
            CHECK(fitted.k[c] < 5);
            CHECK(std::fabs(f(1)[c] - std::min(gold[c], 0.998)) < 1e-9);
            for (const double cosine : {0.8, 0.5, 0.3, 1.0 / 7, 0.05})
                CHECK(std::fabs(f(cosine)[c] - schlick(cosine)[c]) < 0.06);
        }
    }
}

TEST_CASE("models become each other: a material stays itself, a metal keeps its colours at both angles") {
    for (std::size_t i = 0; i < material_names.size(); ++i) {
        CAPTURE(material_names[i]);
        const MeasuredFresnel material{static_cast<Material>(i)};
        const Reflectance f = reflectance_of(material);
        CHECK(MeasuredFresnel::of_reflectance(material.reflectance()) == material);
        const Reflectance f82 = reflectance_of(F82Fresnel::of_reflectance(f));
        const Reflectance conductor = reflectance_of(ConductorFresnel::of_reflectance(f));
        const Reflectance drawn = reflectance_of(CurveFresnel::of_reflectance(f));
        for (int c = 0; c < 3; ++c) {
            CHECK(std::fabs(f82(1)[c] - f(1)[c]) < 1e-6);
            CHECK(std::fabs(conductor(1)[c] - std::min(f(1)[c], 0.998)) < 1e-6);
            CHECK(std::fabs(f82(1.0 / 7)[c] - f(1.0 / 7)[c]) < 0.02);
            CHECK(std::fabs(conductor(1.0 / 7)[c] - f(1.0 / 7)[c]) < 0.02);
            for (const double cosine : {0.9, 0.6, 0.3, 0.1})
                CHECK(std::fabs(drawn(cosine)[c] - f(cosine)[c]) < 0.02);
        }
    }
}

TEST_CASE("a facet on edge, whose cosine may be rounded to below 0, reflects a number") {
    for (std::size_t i = 0; i < KindSet<Fresnel>::count; ++i) {
        CAPTURE(KindSet<Fresnel>::names[i]);
        const Reflectance f = reflectance_of(KindSet<Fresnel>::made(i));
        for (int c = 0; c < 3; ++c) CHECK(std::fabs(f(-1e-16)[c] - f(0)[c]) < 1e-6);
    }
}

TEST_CASE("only a model that is a table has the table in its shader") {
    for (std::size_t i = 0; i < KindSet<Fresnel>::count; ++i) {
        CAPTURE(KindSet<Fresnel>::names[i]);
        ShaderVariant variant;
        variant.kinds.fresnel = static_cast<int>(i);
        const bool reads = shared_mathematics(variant).find("fetch_curve") != std::string::npos;
        CHECK(reads == fresnel_is_curve(i));
        const ShaderFresnel numbers =
            std::visit([](const auto& model) { return model.shader(); }, KindSet<Fresnel>::made(i));
        CHECK((numbers.curve != nullptr) == fresnel_is_curve(i));
    }
}

TEST_SUITE_END();
