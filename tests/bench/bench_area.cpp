// g of a painted p of 512 x 512 texels: from the raster to the table, and one direction against the plain sum
// over texels, which is given vectors as wide as the machine has and four
// directions a pass.
#include <fmt/format.h>

#include <algorithm>

#include "tests/bench/bench_designs.h"
#include "tests/bench/plain_area.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

constexpr int side = 512;
constexpr int directions = 1024;

void add_full(Report& report, Quality quality, const char* name) {
    const std::string what = fmt::format("g of painted 512: raster to table, {}", name);
    add_benchmark(what, 15, [=, &report](benchmark::State& state) {
        const Design design = painted(side);
        const double seconds =
            repeat(state, [&] { benchmark::DoNotOptimize(bake(design, {.quality = quality})); });
        report.add(within(what, seconds, 15e-3));
    });
}

template <class Real>
void add_directions(Report& report, const char* name) {
    const std::string what = fmt::format("g of painted 512: a direction against the plain sum in {}", name);
    add_benchmark(what, 9, [=, &report](benchmark::State& state) {
        const FacetDistribution facets(painted(side).distribution);
        const PlainArea<Real> plain(facets.facets(0).front());
        Random random(5);
        std::vector<dvec3> ks;
        for (int i = 0; i < directions; ++i)
            ks.push_back(
                test::polar(1 - uniform_random(random), 2 * std::numbers::pi * uniform_random(random)));
        std::vector<double> ours(ks.size()), theirs(ks.size());
        const auto projected_area = [&](dvec3 k) { return facets.projected_area(k); };
        const Pair pair = interleave(
            state, directions, [&] { std::transform(ks.begin(), ks.end(), ours.begin(), projected_area); },
            [&] { plain(ks, theirs); });
        double difference = 0;
        for (std::size_t i = 0; i < ks.size(); ++i)
            difference = std::max(difference, std::fabs(theirs[i] - ours[i]) / ours[i]);
        state.counters["difference"] = difference;
        Line line = faster(what, pair, 5);
        line.remark = fmt::format("they differ by {:.1e} at the most, relative", difference);
        report.add(line);
    });
}

}  // namespace

void add_area(Report& report) {
    add_full(report, Quality::draft, "draft");
    add_full(report, Quality::final, "final");
    add_directions<double>(report, "double");
    add_directions<float>(report, "float");
}

}  // namespace nacre::bench
