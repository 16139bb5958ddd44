// Random walks between facets against closed forms.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/model/facet_walks.h"
#include "core/verify/bounce_oracle.h"
#include "tests/core/dense_bounces.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

constexpr int million = 1000000;

Design of(const Lobe& lobe, const MaskingModel& masking) {
    Design design;
    design.distribution.layers.assign(1, Layer{});
    design.distribution.layers[0].lobe = lobe;
    design.fresnel = NoFresnel{};
    design.shadowing.model = masking;
    return design;
}

bool within_three_errors(const WalkEstimate& estimate, double expected) {
    CAPTURE(estimate.mean.x);
    CAPTURE(estimate.error.x);
    CAPTURE(expected);
    return std::fabs(estimate.mean.x - expected) <= 3 * estimate.error.x;
}

const double pairs[][4] = {
    {25, 10, 65, 130}, {5, 0, 40, 200}, {70, 300, 80, 20}};  // theta, phi of k1 and of k2, degrees

dvec3 at(double theta, double phi) { return polar(std::cos(theta * pi / 180), phi * pi / 180); }

}  // namespace

TEST_CASE("orders 1 and 2 of the Smith walk over a uniform hemisphere are the closed forms") {
    const Reference reference(of(UniformLobe{}, SmithCorrelatedMasking{}));
    const BounceOracle oracle(reference);
    for (const auto& [theta1, phi1, theta2, phi2] : pairs) {
        const dvec3 k1 = at(theta1, phi1), k2 = at(theta2, phi2);
        const double c1 = k1.z, c2 = k2.z, s = c1 / (c1 + c2);
        CHECK(within_three_errors(oracle.rho(k1, k2, {.walks = million, .first = 1, .last = 1}),
                                  1 / (2 * pi * (c1 + c2))));
        CHECK(within_three_errors(oracle.rho(k1, k2, {.walks = million, .first = 2, .last = 2}),
                                  (-s * std::log(s) - (1 - s) * std::log(1 - s)) / (2 * pi)));
        CHECK(within_three_errors(oracle.albedo(k1, {.walks = million, .first = 1, .last = 1}),
                                  1 - c1 * std::log((1 + c1) / c1)));
    }
}

TEST_CASE(
    "all orders of the uncorrelated walk over a uniform hemisphere are the closed form, for any constant F") {
    for (const double f : {1.0, 0.6}) {
        Design design = of(UniformLobe{}, UncorrelatedMasking{});
        design.fresnel = CurveFresnel{{{0, dvec3{f}}, {90, dvec3{f}}}};
        const Reference reference(design);
        const BounceOracle oracle(reference);
        for (const auto& [theta1, phi1, theta2, phi2] : pairs) {
            const dvec3 k1 = at(theta1, phi1), k2 = at(theta2, phi2);
            CHECK(within_three_errors(oracle.rho(k1, k2, {.walks = million, .first = 1}),
                                      f / pi * std::pow((1 + k1.z) * (1 + k2.z), f - 1)));
        }
    }
}

TEST_CASE("with F = 1 all light comes back, and the walk is reciprocal, for both walks and any p") {
    Design grooves = of(GaussianLobe{0.2, 0.2}, UncorrelatedMasking{});
    grooves.distribution.layers[0].tilt = 45;
    grooves.distribution.layers.push_back(grooves.distribution.layers[0]);
    grooves.distribution.layers[1].azimuth = 180;
    for (const MaskingModel& masking :
         {MaskingModel{UncorrelatedMasking{}}, MaskingModel{SmithCorrelatedMasking{}}})
        for (Design design :
             {of(GgxLobe{0.25, 1}, masking), of(InverseGaussianLobe{0.5}, masking), grooves}) {
            design.shadowing.model = masking;
            CAPTURE(kind_name(design.distribution.layers[0].lobe));
            CAPTURE(kind_name(masking));
            const Reference reference(design);
            const BounceOracle oracle(reference);
            const dvec3 k1 = at(30, 20), k2 = at(60, 200);
            CHECK(oracle.albedo(k1, {.walks = 2048, .first = 1}).mean.x == doctest::Approx(1).epsilon(1e-3));
            const WalkEffort effort{.walks = 8192};
            const WalkEstimate there = oracle.rho(k1, k2, effort), back = oracle.rho(k2, k1, effort);
            CHECK(std::fabs(there.mean.x - back.mean.x) <= 4 * std::hypot(there.error.x, back.error.x));
        }
}

TEST_CASE("the walk's first bounce is R, and its later ones are the dense solution") {
    const Design design = of(GgxLobe{0.4, 0.4}, UncorrelatedMasking{});
    const Reference reference(design);
    const BounceOracle oracle(reference);
    const dvec3 k = at(55, 30);
    CHECK(within_three_errors(oracle.albedo(k, {.first = 1, .last = 1}), reference.albedo(k)[0]));
    const DenseBounces dense = dense_bounces(reference.distribution(), 300);
    for (std::size_t i : {20u, 150u, 280u})
        for (std::size_t j : {60u, 200u, 260u}) {
            const WalkEstimate walked = oracle.rho(dense.k[i], dense.k[j], {.walks = 100000});
            CAPTURE(walked.mean.x);
            CHECK(std::fabs(walked.mean.x - dense.more(i, j)) <=
                  4 * walked.error.x + 0.05 * dense.more(i, j) + 1e-3);
        }
}
