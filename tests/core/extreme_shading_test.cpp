// The shader's mathematics at the edges of its numbers.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/model/float_shading.h"
#include "core/shading/surface.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using Shader = Shading<double>;

Design masked(const MaskingModel& model, bool clamp) {
    Design design = design_of(GaussianLobe{0.3, 0.3});
    design.shadowing = {model, clamp};
    return design;
}

bool finite(dvec3 value) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(value[i]) || value[i] < 0) return false;
    return true;
}

}  // namespace

TEST_SUITE_BEGIN("extreme shading");

TEST_CASE("correlated visibility stays a number however low both directions stand") {
    std::vector<MaskingModel> models = {CorrelatedMasking{0.1}};
    for (std::size_t i = 0; i < KindSet<MaskingModel>::count; ++i)
        models.push_back(KindSet<MaskingModel>::made(i));
    for (const MaskingModel& model : models)
        for (const bool clamp : {true, false}) {
            CAPTURE(kind_name(model));
            const Brdf brdf(bake(masked(model, clamp), {.quality = Quality::draft}));
            const Shading<float> in_single = in_float(brdf.tables().shading);
            for (const double c : {1e-20, 1e-40, 1e-170, 1e-290, 1e-307, 5e-324})
                for (const double other : {c, 1e-6, 1.0})
                    for (const double side : {-1.0, 1.0}) {
                        CAPTURE(c);
                        const dvec3 a{1, 0, c}, b{side * std::sqrt(1 - other * other), 0, other};
                        const dvec3 rho = brdf.evaluate(a, b);
                        CHECK(finite(rho));
                        CHECK(rho == brdf.evaluate(b, a));
                        CHECK(finite(dvec3(in_single.brdf(glm::vec3(a), glm::vec3(b)))));
                    }
        }
}

TEST_CASE("rho of opposite grazing directions does not depend on how low they stand") {
    const Brdf brdf(bake(design_of(GaussianLobe{0.3, 0.3}), {.quality = Quality::draft}));
    const dvec3 high = brdf.evaluate({1, 0, 1e-12}, {-1, 0, 1e-12});
    CHECK(high.x > 0);
    for (const double c : {1e-100, 1e-160, 1e-170, 1e-300}) {
        CAPTURE(c);
        CHECK(brdf.evaluate({1, 0, c}, {-1, 0, c}).x == doctest::Approx(high.x).epsilon(1e-9));
    }
}

TEST_CASE("rho c of correlated visibility has a limit at the horizon") {
    for (const MaskingModel& model :
         {MaskingModel(CorrelatedMasking{}), MaskingModel(SmithCorrelatedMasking{})}) {
        const Brdf brdf(bake(masked(model, true), {.quality = Quality::draft}));
        auto product = [&](double c) { return c * brdf.evaluate({1, 0, c}, {1, 0, 2 * c}).x; };
        // The half vector of two such directions is tangent, where eq. 34 is 0; a wide lobe keeps facets
        // there.
        CHECK(product(1e-200) == doctest::Approx(product(1e-9)).epsilon(1e-6));
        const Brdf wide(bake([&] {
            Design design = design_of(UniformLobe{});
            design.shadowing.model = model;
            return design;
        }()));
        auto wide_product = [&](double c) { return c * wide.evaluate({1, 0, c}, {1, 0, 2 * c}).x; };
        CHECK(wide_product(1e-9) > 0);
        CHECK(wide_product(1e-300) == doctest::Approx(wide_product(1e-9)).epsilon(1e-6));
    }
}

TEST_CASE("an index of 1 reflects nothing, at grazing too, and an index near 1 hardly anything") {
    for (const double c : {0.0, 1e-300, 1e-9, 0.3, 1.0}) {
        CAPTURE(c);
        CHECK(Shader::dielectric_reflectance(1, c) == 0);
        CHECK(Shader::conductor_reflectance(1, 0, c) == 0);
        CHECK(Shading<float>::dielectric_reflectance(1, static_cast<float>(c)) == 0);
        CHECK(Shading<float>::conductor_reflectance(1, 0, static_cast<float>(c)) == 0);
    }
    CHECK(Shader::dielectric_reflectance(1 + 1e-12, 0) == 1);
    CHECK(Shader::dielectric_reflectance(1 + 1e-12, 0.5) < 1e-20);
}

TEST_CASE("a conductor's reflectance is that of its dielectric when k = 0, and lies in [0, 1]") {
    for (const double c : {0.0, 1e-6, 0.1, 0.7, 1.0})
        for (const double ior : {1.001, 1.5, 10.0})
            CHECK(Shader::conductor_reflectance(ior, 0, c) ==
                  doctest::Approx(Shader::dielectric_reflectance(ior, c)).epsilon(1e-9));
    Random random(5);
    auto spread = [&](double low, double high) { return low * std::pow(high / low, uniform_random(random)); };
    for (int i = 0; i < 20000; ++i) {
        const double eta = spread(limits::eta_min, limits::eta_max), k = spread(1e-12, limits::k_max);
        const double c = i % 3 ? uniform_random(random) : spread(1e-12, 1);
        const double f = Shader::conductor_reflectance(eta, k, c);
        const float single = Shading<float>::conductor_reflectance(
            static_cast<float>(eta), static_cast<float>(k), static_cast<float>(c));
        CHECK((f >= 0 && f <= 1));
        CHECK((single >= 0 && single <= 1));
    }
}

TEST_CASE("a curve's values may lie outside a float's range, and its picture's unit does not reach the GPU") {
    const CurveLobe plain{{{0, 1}, {30, 0.5}, {60, 0}}};
    CurveLobe tiny = plain;
    for (auto& point : tiny.points) point.second *= 0x1p-900;
    const FacetDistribution p(design_of(plain).distribution), scaled(design_of(tiny).distribution);
    CHECK(scaled.density({0, 0, 1}) == p.density({0, 0, 1}));
    for (const double brightness : {0x1p-120, 0x1p127}) {
        const Design design = design_of(PaintedLobe{
            picture_of(4, [&](double x, double y) { return brightness * (x > 0 && y > 0 ? 1 : 0.5); })});
        Shading<double> shading;
        std::vector<float> data;
        const FacetDistribution facets(design.distribution);
        describe_layers(design.distribution, facets, shading, data);
        shading.data = data.data();
        CHECK(shading.layers[0].scale > 1e-3);
        CHECK(shading.layers[0].scale < 1e3);
        for (const dvec3 h : {polar(0.9, 0.3), polar(0.3, 2.0)})
            CHECK(shading.density(h) == doctest::Approx(facets.density(h)).epsilon(1e-12));
    }
}

TEST_CASE("a modulation's unit does not reach the GPU") {
    for (const double brightness : {1e-30, 0.3, 1.0, 7.0, 1e30})
        for (const double strength : {0.25, 1.0}) {
            CAPTURE(brightness);
            Design design = design_of(GaussianLobe{0.5, 0.5});
            design.distribution.layers[0].modulation = Modulation{
                picture_of(4, [&](double x, double) { return brightness * (x > 0 ? 1 : 0.5); }), strength};
            Shading<double> shading;
            std::vector<float> data;
            const FacetDistribution facets(design.distribution);
            describe_layers(design.distribution, facets, shading, data);
            shading.data = data.data();
            for (const dvec3 h : {polar(0.9, 0.3), polar(0.8, 2.0)})
                CHECK(shading.density(h) == doctest::Approx(facets.density(h)).epsilon(1e-9));
            CHECK(static_cast<float>(shading.layers[0].scale) > 0);
            CHECK(std::isfinite(static_cast<float>(shading.layers[0].scale)));
        }
}

TEST_CASE("visible facets of a curve down to the nadir are seen") {
    for (const double end : {90.0, 150.0, 180.0}) {
        CAPTURE(end);
        const FacetDistribution p(design_of(CurveLobe{{{0, 1}, {end, 0.2}}}).distribution);
        Random random(3);
        for (int i = 0; i < 2000; ++i) {
            const dvec3 k = random_direction(random);
            const dvec3 h = p.sample_visible(k, random);
            CHECK(glm::length(h) == doctest::Approx(1).epsilon(1e-9));
            CHECK(glm::dot(h, k) > -1e-12);
            CHECK(p.density(h) > 0);
        }
    }
}

TEST_SUITE_END();
