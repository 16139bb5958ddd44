// All tables of a design: drafts and finals, and the paper's way to the same error (a plain grid over theta
// and phi, filled by Monte Carlo).
#include <fmt/core.h>

#include <algorithm>

#include "core/verify/table_error.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/monte_carlo.h"
#include "tests/bench/paper_grid.h"
#include "tests/bench/subjects.h"

namespace nacre::bench {
namespace {

constexpr double tolerance = 1e-3;

void add_everything(Report& report, const char* name, const Design& design, Quality quality, double wanted) {
    const std::string what =
        fmt::format("g and R of {}: {}", name, quality == Quality::draft ? "draft" : "final");
    add_benchmark(what, 11, [=, &report](benchmark::State& state) {
        const BakeOptions options{.quality = quality, .albedo = true, .tolerance = tolerance};
        std::shared_ptr<const Tables> tables;
        const double seconds = repeat(state, [&] { tables = bake(design, options); });
        Line line = within(what, seconds, wanted);
        const auto& n = tables->size;
        line.remark = fmt::format("{} x {} and {} x {} nodes", n.w, n.psi, n.v, n.rho);
        report.add(line);
    });
}

// Worst over probe directions, as area_error() measures it.
double grid_error(const PaperGrid& grid, const Tables& tables) {
    const Shading<double>& shading = tables.shading;
    double worst = 0;
    for (const dvec3 k : probe_directions(400)) {
        const double exact = tables.distribution->area(k).g;
        worst = std::max(worst, area_error(shading, k, grid.at(k), exact));
    }
    return worst;
}

struct Cost {
    double seconds = 0;  // of a whole table, extrapolated from the samples below
    double samples = 0;  // of g and of R, in all
};

// What Monte Carlo takes to give every node a standard error of the tolerance: relative for g, absolute for
// R.
Cost monte_carlo_cost(const PaperGrid& grid, const Tables& tables) {
    constexpr int probes = 32, samples = 2000;
    const AlbedoSampler albedo(*tables.distribution, tables.shading, Sampling::slopes);
    const std::vector<dvec3> nodes = grid.directions();
    Random random(11);
    Cost cost;
    for (int i = 0; i < probes; ++i) {
        const dvec3 k = nodes[(static_cast<std::size_t>(i) * 2 + 1) * nodes.size() / (2 * probes)];
        const double g = tables.distribution->area(k).g;
        const auto k1 = Shading<double>::known_direction(k, g, dvec3{0});
        Moments of_g, of_r;
        const double seconds_g = seconds_of([&] {
            for (int s = 0; s < samples; ++s) {
                const Facet facet = sample_slopes(tables.shading, random);
                of_g.add(dvec2{facet.mass * std::max(glm::dot(facet.h, k), 0.0)});
            }
        });
        const double seconds_r = seconds_of([&] {
            for (int s = 0; s < samples; ++s) of_r.add(albedo(k1, random));
        });
        const double needed_g = of_g.variance() / std::pow(tolerance * g, 2);
        const double needed_r = of_r.variance() / std::pow(tolerance, 2);
        const double share = static_cast<double>(grid.nodes()) / probes;
        cost.seconds += share * (seconds_g * needed_g + seconds_r * needed_r) / samples;
        cost.samples += share * (needed_g + needed_r);
    }
    return cost;
}

// The grid with exact values whose error between nodes is at most `error`; 20 x 10 is the paper's.
PaperGrid grid_within(double error, const Tables& tables) {
    PaperGrid grid(20, 10);
    grid.fill(*tables.distribution);
    for (int finer = 2; finer <= 64 && grid_error(grid, tables) > error; finer *= 2) {
        grid = PaperGrid(20 * finer, 10 * finer);
        grid.fill(*tables.distribution);
    }
    return grid;
}

void add_paper(Report& report, const char* name, double error) {
    const std::string what = fmt::format("all tables of Gaussian (0.1, 1): one thread against {}", name);
    add_benchmark(what, 7, [=, &report](benchmark::State& state) {
        const BakeOptions options{.albedo = true, .threads = 1, .tolerance = tolerance};
        std::shared_ptr<const Tables> tables;
        Pair pair;
        pair.ours = repeat(state, [&] { tables = bake(brushed_coupled(), options); });
        const PaperGrid grid = grid_within(error, *tables);
        const Cost cost = monte_carlo_cost(grid, *tables);
        pair.theirs = cost.seconds;
        state.counters["theirs_s"] = pair.theirs;
        Line line = faster(what, pair, 50);
        line.remark =
            fmt::format("{} nodes, g within {:.1e} (ours {:.1e}); {:.1e} samples, extrapolated", grid.nodes(),
                        grid_error(grid, *tables), tables->errors.area.worst, cost.samples);
        report.add(line);
    });
}

}  // namespace

void add_bake(Report& report) {
    add_everything(report, "Gaussian (0.1, 1)", brushed_coupled(), Quality::draft, 16e-3);
    add_everything(report, "Gaussian (0.1, 1)", brushed_coupled(), Quality::final, 150e-3);
    add_everything(report, "painted 512", painted(512), Quality::draft, 16e-3);
    add_everything(report, "painted 512", painted(512), Quality::final, 150e-3);
    add_paper(report, "the paper's 200 points", 1e9);
    add_paper(report, "a plain grid within 1e-3", tolerance);
}

}  // namespace nacre::bench
