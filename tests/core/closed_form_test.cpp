// Lobes against the closed forms of the field (docs/mathematics.md, sec. 7; Walter et al. 2007; Heitz 2014).
#include <doctest/doctest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/expint.hpp>
#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;
using std::numbers::pi;

namespace {

std::shared_ptr<const LobeModel> model_of(Lobe lobe) {
    Layer layer;
    layer.lobe = std::move(lobe);
    return make_lobe(layer);
}

double scaled_erfc(double x) { return std::exp(x * x) * std::erfc(x); }

// P of a GGX surface with widths (ax, ay): N = 1, g = (c + r)/2.
double ggx_visibility(dvec3 k, double ax, double ay) {
    return 2 * k.z / (k.z + std::hypot(ax * k.x, ay * k.y, k.z));
}

double beckmann_visibility(dvec3 k, double ax, double ay) {
    const double q = std::hypot(ax * k.x, ay * k.y), v = k.z / q;
    return k.z / (0.5 * k.z * (1 + std::erf(v)) + q * std::exp(-v * v) / (2 * std::sqrt(pi)));
}

// P from the tables, as a renderer reads it.
double baked_visibility(const Tables& tables, dvec3 k) {
    return tables.shading.surface.N * k.z / tables.shading.projected_area(k, tables.shading.table_spot(k));
}

}  // namespace

TEST_SUITE_BEGIN("closed forms");

TEST_CASE("eq. 34, wide: integral, mean cosine and grazing area") {
    for (const double s : {0.2, 0.5, 1.0, 3.0, 10.0, 1e4}) {
        CAPTURE(s);
        const auto lobe = model_of(GaussianLobe{s, s});
        const double a = 1 / (s * s), e = scaled_erfc(1 / s);
        CHECK(lobe->mass() == doctest::Approx(2 * pi * (1 - std::sqrt(pi * a) * e)).epsilon(1e-10));
        CHECK(lobe->mean().z ==
              doctest::Approx(pi * (1 - a * std::exp(a) * boost::math::expint(1, a))).epsilon(1e-10));
        CHECK(lobe->area({1, 0, 0}).g ==
              doctest::Approx((1 + 2 * a) * (pi / 2) * e - std::sqrt(pi * a)).epsilon(1e-9));
    }
}

TEST_CASE("eq. 34, narrow: the asymptotic series of the same forms") {
    for (const double s : {1e-4, 1e-3, 0.01}) {
        CAPTURE(s);
        const auto lobe = model_of(GaussianLobe{s, s});
        const double s2 = s * s;
        CHECK(lobe->mass() == doctest::Approx(pi * s2 * (1 - 1.5 * s2 + 3.75 * s2 * s2)).epsilon(1e-10));
        CHECK(lobe->mean().z == doctest::Approx(pi * s2 * (1 - 2 * s2 + 6 * s2 * s2)).epsilon(1e-10));
        const double grazing = std::sqrt(pi) / 2 * s2 * s * (1 - 3 * s2 + 11.25 * s2 * s2);
        CHECK(lobe->area({0, 1, 0}).g == doctest::Approx(grazing).epsilon(1e-10));
    }
}

TEST_CASE("eq. 34 with both widths infinite is the uniform hemisphere") {
    const auto lobe = model_of(GaussianLobe{limits::infinity, limits::infinity});
    Random random(3);
    CHECK(lobe->mass() == doctest::Approx(2 * pi).epsilon(1e-11));
    for (int i = 0; i < 20; ++i) {
        const dvec3 k = random_direction(random);
        CHECK(lobe->area(k).g / lobe->mass() == doctest::Approx((1 + k.z) / 4).epsilon(1e-10));
        CHECK(lobe->area(-k).g / lobe->mass() == doctest::Approx((1 - k.z) / 4).epsilon(1e-9));
    }
}

TEST_CASE("eq. 35: integral, mean cosine and grazing area") {
    for (const double s : {0.3, 0.5, 1.0, 3.0}) {
        CAPTURE(s);
        const auto lobe = model_of(InverseGaussianLobe{s});
        const double a = 1 / (s * s);
        const double bessel = boost::math::cyl_bessel_k(1, a / 2) - boost::math::cyl_bessel_k(0, a / 2);
        CHECK(lobe->mass() == doctest::Approx(pi * a * std::exp(a / 2) * bessel).epsilon(1e-9));
        const double n = pi * (1 - a * std::exp(a) * boost::math::expint(1, a));
        CHECK(lobe->area({0, 0, 1}).g == doctest::Approx(n).epsilon(1e-9));
        const double grazing = (1 - 2 * a) * (pi / 2) * scaled_erfc(1 / s) + std::sqrt(pi * a);
        CHECK(lobe->area({1, 0, 0}).g == doctest::Approx(grazing).epsilon(1e-9));
    }
}

TEST_CASE("a curve of ones is the uniform hemisphere, one to 180 degrees the sphere") {
    const auto hemisphere = model_of(CurveLobe{{{0, 1}, {90, 1}}});
    const auto sphere = model_of(CurveLobe{{{0, 1}, {180, 1}}});
    CHECK(hemisphere->mass() == doctest::Approx(2 * pi).epsilon(1e-7));
    CHECK(sphere->mass() == doctest::Approx(4 * pi).epsilon(1e-7));
    Random random(4);
    for (int i = 0; i < 20; ++i) {
        const dvec3 k = random_direction(random);
        CHECK(hemisphere->area(k).g / (2 * pi) == doctest::Approx((1 + k.z) / 4).epsilon(1e-6));
        CHECK(sphere->area(-k).g / (4 * pi) == doctest::Approx(0.25).epsilon(1e-6));
    }
}

TEST_CASE("a white painted disk is the uniform hemisphere") {
    const auto lobe = model_of(PaintedLobe{picture_of(64, [](double, double) { return 1.0; })});
    CHECK(lobe->mass() == doctest::Approx(2 * pi).epsilon(2e-3));
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        const dvec3 k = random_direction(random);
        CHECK(lobe->area(k).g / lobe->mass() == doctest::Approx((1 + k.z) / 4).epsilon(2e-3));
    }
}

TEST_CASE("area of GGX and Beckmann facets: normalised to <n.h> = 1 they have the known integral") {
    CHECK(model_of(GgxLobe{1, 1})->mass() == doctest::Approx(2 * pi).epsilon(1e-12));
    // Mean of sqrt(1 + r^2) over exp(-r^2/a^2) slopes at a = 1: 1 + e sqrt(pi)/2 erfc(1).
    const double mean = 1 + std::exp(1) * std::sqrt(pi) / 2 * std::erfc(1);
    CHECK(model_of(BeckmannLobe{1, 1})->mass() == doctest::Approx(pi * mean).epsilon(1e-11));
}

TEST_CASE("P of the reference and of the tables, down to c = 1e-5 and widths from 1e-3 to 10") {
    Random random(6);
    for (const auto& widths :
         {std::pair{1e-3, 1e-3}, {1e-3, 0.1}, {0.05, 0.4}, {0.3, 0.3}, {1.0, 3.0}, {10.0, 10.0}}) {
        const double ax = widths.first, ay = widths.second;
        CAPTURE(ax);
        CAPTURE(ay);
        for (const bool ggx : {true, false}) {
            const Design design = ggx ? design_of(GgxLobe{ax, ay}) : design_of(BeckmannLobe{ax, ay});
            const Reference reference(design);
            const auto tables = bake(design);
            for (int i = 0; i < 40; ++i) {
                const dvec3 k = i == 0   ? polar(1e-5, 0)
                                : i == 1 ? polar(1e-5, 1.3)
                                         : random_direction(random);
                const double exact = ggx ? ggx_visibility(k, ax, ay) : beckmann_visibility(k, ax, ay);
                CHECK(reference.visibility(k) == doctest::Approx(exact).epsilon(1e-9));
                CHECK(std::fabs(baked_visibility(*tables, k) / exact - 1) < 1e-3);
            }
        }
    }
}

TEST_CASE("R of the uniform hemisphere: 2 (1 - ln 2)/(1 + c), and its mean") {
    const Design design = design_of(UniformLobe{});
    const Reference reference(design);
    const auto tables = bake(design, {.albedo = true});
    for (const double c : {1e-5, 1e-3, 0.1, 0.5, 0.9, 1.0}) {
        CAPTURE(c);
        const double exact = 2 * (1 - std::numbers::ln2) / (1 + c);
        const dvec3 k = polar(c, 0.4);
        CHECK(reference.albedo(k)[0] == doctest::Approx(exact).epsilon(1e-6));
        const auto spot = tables->shading.albedo_spot(k, tables->shading.table_spot(k));
        CHECK(std::fabs(tables->shading.albedo_f1(spot) - exact) < 5e-4);
    }
    CHECK(tables->mean_albedo.x == doctest::Approx(4 * std::pow(1 - std::numbers::ln2, 2)).epsilon(1e-3));
}

TEST_SUITE_END();
