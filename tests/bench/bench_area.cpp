// g of a painted p of 512 x 512 texels: from the raster to the table, and one direction against the plain sum
// over texels, which is given vectors as wide as the machine has and four
// directions a pass.
#include <fmt/core.h>

#include <algorithm>

#include "core/bake/area_table.h"
#include "core/model/picture_lobe.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/plain_area.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

constexpr int side = 512;
constexpr int directions = 1024;

void add_full(Report& report, const char* name, const BakeOptions& options) {
    const std::string what = fmt::format("g of painted 512: raster to table, {}", name);
    add_benchmark(what, 15, [=, &report](benchmark::State& state) {
        const Design design = painted(side);
        std::shared_ptr<const Tables> tables;
        const double seconds = repeat(state, [&] { tables = bake(design, options); });
        Line line = within(what, seconds, 15e-3);
        line.remark = fmt::format("{} x {} nodes, g within {:.1e}", tables->size.w, tables->size.psi,
                                  tables->errors.area.worst);
        report.add(line);
    });
}

// The painted design with a square of 16 x 16 texels raised.
Design dabbed() {
    Design design = painted(side);
    Picture& image = std::get<PaintedLobe>(design.distribution.layers[0].lobe).image;
    Raster raster = *image.raster;
    for (int row = 200; row < 216; ++row)
        for (int column = 300; column < 316; ++column)
            raster.values[static_cast<std::size_t>(row * side + column)] += 0.5F;
    image.raster = std::make_shared<const Raster>(std::move(raster));
    return design;
}

// From the touched raster to the table of g, against the same from the raster alone.
void add_dab(Report& report) {
    const std::string what = "g of painted 512, 33 x 64 nodes: a dab of 16 x 16 against all of it";
    add_benchmark(what, 25, [=, &report](benchmark::State& state) {
        Workers workers(0);
        const TableNodes nodes{33, 64};
        const Design before = painted(side), after = dabbed();
        const Layer& layer = after.distribution.layers[0];
        auto anew = [&](const Design& design) {
            return AreaTable(std::make_shared<const FacetDistribution>(design.distribution), {}, nodes, false,
                             Quality::draft, workers);
        };
        const AreaTable table = anew(before);
        const LobeModel& lobe = *table.distribution()->lobes()[0].lobe;
        const Pair pair = interleave(
            state, 1,
            [&] {
                const auto touched = repaint(lobe, layer);
                auto distribution = std::make_shared<const FacetDistribution>(
                    after.distribution, [&](const Layer&, std::size_t) { return touched; });
                benchmark::DoNotOptimize(
                    AreaTable(table, distribution, {*painted_between(lobe, *touched)}, workers));
            },
            [&] { benchmark::DoNotOptimize(anew(after)); });
        report.add(faster(what, pair, 30));
        report.add(within("  the dab", pair.ours, 1e-3));
        report.add(within("  all of it", pair.theirs, 15e-3));
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
        line.remark = fmt::format("they differ by at most {:.1e}, relative", difference);
        report.add(line);
    });
}

}  // namespace

void add_area(Report& report) {
    add_full(report, "draft", {.quality = Quality::draft});
    add_full(report, "to 1e-3", {});
    add_dab(report);
    add_directions<double>(report, "double");
    add_directions<float>(report, "float");
}

}  // namespace nacre::bench
