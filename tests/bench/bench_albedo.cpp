// R of one direction: the bake's rule against Monte Carlo at an equal error, which is measured against the
// adaptive reference. Monte Carlo's number of samples follows from its measured variance; one run verifies
// it.
#include <fmt/core.h>

#include <algorithm>

#include "core/verify/reference.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/monte_carlo.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

constexpr int directions = 8;
constexpr int samples_timed = 20000;      // a direction
constexpr double samples_verified = 2e6;  // at most, for a direction

struct Setup {
    explicit Setup(const Design& design)
        : tables(bake(design, {.albedo = true})), rule(*tables->distribution, tables->shading, 1, 1e-4) {
        const Reference reference(design);
        for (int i = 0; i < directions; ++i) {
            const dvec3 k = test::polar(0.97 - 0.12 * i, 0.4 + 1.3 * i);
            ks.push_back(Shading<double>::known_direction(k, tables->distribution->area(k).g, dvec3{0}));
            const AlbedoValues values = reference.albedo(k);
            truth.emplace_back(values[0], values[1]);
        }
    }

    dvec2 ours(std::size_t i) const {
        const AlbedoValues values = rule(ks[i].k, ks[i].g);
        return {values[0], values[1]};
    }

    std::shared_ptr<const Tables> tables;
    AlbedoQuadrature rule;
    std::vector<Shading<double>::Direction> ks;
    std::vector<dvec2> truth;
};

// Root mean square over the directions, of the worse of both R.
template <class Value>
double error_of(const Setup& setup, const Value& value) {
    double squares = 0;
    for (std::size_t i = 0; i < directions; ++i) {
        const dvec2 e = glm::abs(value(i) - setup.truth[i]);
        squares += std::pow(std::max(e.x, e.y), 2) / directions;
    }
    return std::sqrt(squares);
}

Moments sample(const AlbedoSampler& sampler, const Shading<double>::Direction& k, double samples,
               Random& random) {
    Moments moments;
    while (moments.count < samples) moments.add(sampler(k, random));
    return moments;
}

void add(Report& report, const char* name, const Design& design, Sampling sampling, const char* way) {
    const std::string what = fmt::format("R of {}: rule against Monte Carlo, {}", name, way);
    add_benchmark(what, 7, [=, &report](benchmark::State& state) {
        const Setup setup(design);
        const AlbedoSampler sampler(*setup.tables->distribution, setup.tables->shading, sampling);
        Random random(3);
        double variance = 0;
        for (const auto& k : setup.ks) variance += sample(sampler, k, 1e5, random).variance() / directions;
        const double error = error_of(setup, [&](std::size_t i) { return setup.ours(i); });
        const double samples = std::max(1.0, variance / (error * error));
        Pair pair = interleave(
            state, directions,
            [&] {
                for (std::size_t i = 0; i < directions; ++i) benchmark::DoNotOptimize(setup.ours(i));
            },
            [&] {
                for (const auto& k : setup.ks)
                    benchmark::DoNotOptimize(sample(sampler, k, samples_timed, random));
            });
        pair.theirs *= samples / samples_timed;
        const double run = std::min(samples, samples_verified);
        const double verified =
            error_of(setup, [&](std::size_t i) { return sample(sampler, setup.ks[i], run, random).mean(); });
        state.counters["samples"] = samples;
        Line line = faster(what, pair, 20);
        line.remark = fmt::format(
            "error {:.1e}, {:.1e} samples; a run of {:.0e} samples has an error of {:.1e}, expected {:.1e}",
            error, samples, run, verified, std::sqrt(variance / run));
        report.add(line);
    });
}

}  // namespace

void add_albedo(Report& report) {
    add(report, "Gaussian (0.1, 1)", brushed(), Sampling::uniform_hemisphere, "uniform hemisphere");
    add(report, "Gaussian (0.1, 1)", brushed(), Sampling::slopes, "normal slopes");
    const Design ggx = test::design_of(GgxLobe{0.2, 0.2});
    add(report, "GGX (0.2, 0.2)", ggx, Sampling::uniform_hemisphere, "uniform hemisphere");
    add(report, "GGX (0.2, 0.2)", ggx, Sampling::visible_normals, "visible normals");
}

}  // namespace nacre::bench
