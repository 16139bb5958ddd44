// Sampling: weights, energy and the chi-square test at pbrt's settings (10 x 20 bins, 5 runs, significance
// 0.01 with the Sidak correction, bins under 5 expected pooled). NACRE_CHI2_SAMPLES=1000000 takes pbrt's
// count too.
#include <doctest/doctest.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "core/bake/bake.h"
#include "core/bake/brdf_samples.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;
using std::numbers::pi;

namespace {

constexpr int theta_bins = 10, phi_bins = 20, runs = 5;

int sample_count() {
    const char* wanted = std::getenv("NACRE_CHI2_SAMPLES");
    return wanted ? std::atoi(wanted) : 60000;
}

const int samples = sample_count();

struct NamedDesign {
    const char* name;
    Design design;
};

std::vector<NamedDesign> designs() {
    Design modulated = design_of(GaussianLobe{0.6, 0.6});
    modulated.distribution.layers[0].modulation =
        Modulation{picture_of(32, [](double x, double y) { return 0.2 + 0.8 * (x * y > 0); }), 1};
    return {
        {"gaussian", design_of(GaussianLobe{0.5, 0.3})},
        {"cylinder", design_of(GaussianLobe{0.5, limits::infinity})},
        {"ggx", design_of(GgxLobe{0.5, 0.3}, 0, 0, 20)},
        {"beckmann", design_of(BeckmannLobe{0.6, 0.4})},
        {"velvet", design_of(InverseGaussianLobe{0.7})},
        {"curve", design_of(CurveLobe{{{5, 0}, {30, 1}, {70, 0.2}}})},
        {"uniform", design_of(UniformLobe{})},
        {"tilted", design_of(GaussianLobe{0.5, 0.8}, 30, 20)},
        {"mixture", with_layer(design_of(GaussianLobe{0.4, 0.4}), UniformLobe{UniformDomain::sphere}, 0.5)},
        {"painted", design_of(PaintedLobe{picture_of(
                        24, [](double x, double y) { return std::exp(-2 * (x * x + 2 * y * y)); })})},
        {"modulated", modulated}};
}

dvec3 direction_in_bin(int bin, double u, double v) {
    const double cosine = 1 - (bin / phi_bins + u) / theta_bins;
    return polar(cosine, 2 * pi * (bin % phi_bins + v) / phi_bins);
}

std::vector<double> expected_counts(const Brdf& brdf, dvec3 k1) {
    std::vector<double> expected(theta_bins * phi_bins);
    constexpr int fine = 24;
    for (int bin = 0; bin < theta_bins * phi_bins; ++bin)
        for (int i = 0; i < fine * fine; ++i) {
            const dvec3 k2 = direction_in_bin(bin, (i / fine + 0.5) / fine, (i % fine + 0.5) / fine);
            expected[static_cast<std::size_t>(bin)] +=
                brdf.pdf(k1, k2) * samples * (2 * pi / theta_bins / phi_bins) / (fine * fine);
        }
    return expected;
}

std::vector<BrdfSample> one_by_one(const Brdf& brdf, dvec3 k1, Random& random) {
    std::vector<BrdfSample> drawn;
    for (int i = 0; i < samples; ++i)
        if (const auto sample = brdf.sample(k1, random)) drawn.push_back(*sample);
    return drawn;
}

std::vector<BrdfSample> side_by_side(const Brdf& brdf, dvec3 k1, Random& random) {
    std::vector<BrdfSample> drawn(static_cast<std::size_t>(samples));
    sample_directions(brdf, std::vector<dvec3>(drawn.size(), k1), random, drawn);
    std::erase_if(drawn, [](const BrdfSample& sample) { return sample.pdf == 0; });
    return drawn;
}

std::vector<double> observed_counts(const std::vector<BrdfSample>& drawn) {
    std::vector<double> observed(theta_bins * phi_bins);
    for (const BrdfSample& sample : drawn) {
        const int row = std::min(static_cast<int>((1 - sample.k2.z) * theta_bins), theta_bins - 1);
        double turn = std::atan2(sample.k2.y, sample.k2.x) / (2 * pi);
        if (turn < 0) turn += 1;
        const int column = std::min(static_cast<int>(turn * phi_bins), phi_bins - 1);
        observed[static_cast<std::size_t>(row * phi_bins + column)] += 1;
    }
    return observed;
}

// Probability of counts this far from what is expected.
double significance(std::vector<double> expected, std::vector<double> observed) {
    // What never came up: samples below the horizon.
    double e = samples, o = samples;
    for (const double x : expected) e -= x;
    for (const double x : observed) o -= x;
    expected.push_back(std::max(e, 0.0));
    observed.push_back(o);
    double statistic = 0, pooled_expected = 0, pooled_observed = 0;
    int degrees = -1;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] < 5 || pooled_expected > 0) {
            if (expected[i] < 5) {
                pooled_expected += expected[i];
                pooled_observed += observed[i];
                continue;
            }
        }
        statistic += (observed[i] - expected[i]) * (observed[i] - expected[i]) / expected[i];
        ++degrees;
    }
    if (pooled_expected > 1) {
        statistic +=
            (pooled_observed - pooled_expected) * (pooled_observed - pooled_expected) / pooled_expected;
        ++degrees;
    } else {
        CHECK(pooled_observed <= 10);
    }
    if (degrees < 1) return 1;
    return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), statistic));
}

}  // namespace

TEST_SUITE_BEGIN("sampling");

TEST_CASE("samples follow the pdf (chi-square)") {
    const double level = 1 - std::pow(1 - 0.01, 1.0 / (2 * runs));
    for (const NamedDesign& d : designs()) {
        CAPTURE(d.name);
        const Brdf brdf(bake(d.design));
        Random random(17);
        for (int run = 0; run < runs; ++run) {
            const dvec3 k1 = polar(0.1 + 0.18 * run, 0.7 + 1.1 * run);
            CAPTURE(k1.z);
            const std::vector<double> expected = expected_counts(brdf, k1);
            CHECK(significance(expected, observed_counts(one_by_one(brdf, k1, random))) > level);
            CHECK(significance(expected, observed_counts(side_by_side(brdf, k1, random))) > level);
        }
    }
}

TEST_CASE("a sample's weight is eval cos/pdf, and never above F (1 + 1e-3) for a valid p") {
    for (const NamedDesign& d : designs()) {
        CAPTURE(d.name);
        Design design = d.design;
        design.fresnel = SchlickFresnel{glm::dvec3{0.2, 0.5, 1.0}};
        const Brdf brdf(bake(design));
        const dvec3 mean = glm::normalize(brdf.tables().mean);
        const bool valid = mean.z > 1 - 1e-12 && d.design.distribution.layers.size() == 1;
        Random random(18);
        for (int i = 0; i < 3000; ++i) {
            const dvec3 k1 = random_direction(random);
            const auto sample = brdf.sample(k1, random);
            if (!sample) continue;
            const dvec3 value = brdf.evaluate(k1, sample->k2);
            const double cosine = 0.5 * glm::length(k1 + sample->k2);
            for (int c = 0; c < 3; ++c) {
                CHECK(sample->weight[c] ==
                      doctest::Approx(value[c] * sample->k2.z / sample->pdf).epsilon(1e-12));
                if (valid)
                    CHECK(sample->weight[c] <=
                          brdf.tables().shading.fresnel(std::min(cosine, 1.0))[c] * (1 + 1e-3));
            }
            CHECK(brdf.pdf(k1, sample->k2) == sample->pdf);
        }
    }
}

TEST_CASE("many samples at once hold what evaluate() and pdf() say of them, whatever their number") {
    for (NamedDesign d : designs()) {
        CAPTURE(d.name);
        d.design.diffuse = CoupledDiffuse{};
        const Brdf brdf(bake(d.design));
        Random random(21);
        for (const std::size_t count : {1U, 7U, 300U}) {
            std::vector<dvec3> k1;
            for (std::size_t i = 0; i < count; ++i)
                k1.push_back(i % 50 == 3 ? dvec3{0, 0.6, -0.8} : random_direction(random));
            std::vector<BrdfSample> drawn(count);
            sample_directions(brdf, k1, random, drawn);
            for (std::size_t i = 0; i < count; ++i) {
                if (drawn[i].pdf == 0) {
                    CHECK(drawn[i].weight == dvec3{0});
                    continue;
                }
                CHECK(k1[i].z > 0);
                CHECK(drawn[i].k2.z > 0);
                CHECK(drawn[i].pdf == doctest::Approx(brdf.pdf(k1[i], drawn[i].k2)).epsilon(1e-9));
                const dvec3 value = brdf.evaluate(k1[i], drawn[i].k2) * (drawn[i].k2.z / drawn[i].pdf);
                for (int c = 0; c < 3; ++c)
                    CHECK(drawn[i].weight[c] == doctest::Approx(value[c]).epsilon(1e-9));
            }
        }
    }
}

TEST_CASE("the mean weight is the albedo") {
    for (const NamedDesign& d : designs()) {
        CAPTURE(d.name);
        const Brdf brdf(bake(d.design, {.albedo = true}));
        Random random(19);
        for (const double c : {0.05, 0.4, 0.9}) {
            const dvec3 k1 = polar(c, 1);
            double sum = 0, squares = 0;
            constexpr int n = 10000;
            for (int i = 0; i < n; ++i) {
                const auto sample = brdf.sample(k1, random);
                const double w = sample ? sample->weight.x : 0;
                sum += w / n;
                squares += w * w / n;
            }
            const double deviation = std::sqrt(std::max(squares - sum * sum, 0.0) / n);
            CHECK(std::fabs(sum - brdf.albedo(k1).x) < 4 * deviation + 3e-3);
        }
    }
}

TEST_SUITE_END();
