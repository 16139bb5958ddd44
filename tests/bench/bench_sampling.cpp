// Samples of the BRDF and visible facets, in double and with the same random numbers, against spherical caps
// of GGX, one call for each direction.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "core/bake/brdf_samples.h"
#include "core/design/design_file.h"
#include "core/model/visible_facets.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

using std::numbers::pi;

constexpr std::size_t count = 4096;
constexpr int repetitions = 51;

// Dupuy & Benyoub 2023, listing 3.
struct SphericalCap {
    dvec3 operator()(dvec3 k, Random& random) const {
        const dvec3 s = glm::normalize(dvec3{alpha.x * k.x, alpha.y * k.y, k.z});
        const double z = (1 - uniform_random(random)) * (1 + s.z) - s.z;
        const double phi = 2 * pi * uniform_random(random);
        const double sine = std::sqrt(std::fmax(1 - z * z, 0.0));
        const dvec3 h{s.x + sine * std::cos(phi), s.y + sine * std::sin(phi), s.z + z};
        return glm::normalize(dvec3{alpha.x * h.x, alpha.y * h.y, std::fmax(h.z, 0.0)});
    }
    dvec2 alpha;
};

struct Named {
    std::string name;
    Design design;
};

// Every preset, and pictures of 512 x 512 texels: strokes, noise, and one texel in a hundred.
std::vector<Named> sampled_designs() {
    std::vector<Named> designs;
    for (const auto& entry : std::filesystem::directory_iterator(NACRE_SOURCE_DIR "/presets"))
        if (entry.path().extension() == ".nacre")
            designs.push_back({entry.path().stem().string(), load_design(entry.path())});
    std::sort(designs.begin(), designs.end(), [](const Named& a, const Named& b) { return a.name < b.name; });
    Random random(3);
    const auto painting = [](const auto& value) {
        return test::design_of(PaintedLobe{test::picture_of(512, value)});
    };
    designs.push_back({"painted 512", painted(512)});
    designs.push_back(
        {"noise 512", painting([&](double, double) { return std::pow(uniform_random(random), 8); })});
    designs.push_back({"scattered texels 512",
                       painting([&](double, double) { return uniform_random(random) < 0.01 ? 1 : 0; })});
    return designs;
}

std::vector<dvec3> directions() {
    Random random(13);
    std::vector<dvec3> ks;
    for (std::size_t i = 0; i < count; ++i)
        ks.push_back(test::polar(1 - uniform_random(random), 2 * pi * uniform_random(random)));
    return ks;
}

// What part of the facets that are drawn is seen.
double kept_of(const FacetDistribution& p, const std::vector<dvec3>& ks) {
    double trials = 0;
    for (std::size_t i = 0; i < 256; ++i) trials += p.visible_facets().bound(ks[i]) / p.projected_area(ks[i]);
    return 256 / trials;
}

// sample(brdf, ks, random) draws for each of the directions.
template <class Sample>
void add(Report& report, const std::string& what, const Design& design, double wanted, Sample sample) {
    add_benchmark(what, repetitions, [=, &report](benchmark::State& state) mutable {
        const Brdf brdf(bake(design));
        const SphericalCap caps{{0.1, 0.3}};
        Random random(17);
        const std::vector<dvec3> ks = directions();
        const double kept = kept_of(*brdf.tables().distribution, ks);
        const Pair pair = interleave(
            state, count, [&] { sample(brdf, ks, random); },
            [&] {
                for (const dvec3 k : ks) benchmark::DoNotOptimize(caps(k, random));
            },
            Time::processor);
        Line line = at_most_times(what, pair, wanted);
        line.remark = fmt::format("{:.0f} % of the facets drawn are kept", 100 * kept);
        report.add(std::move(line));
    });
}

}  // namespace

void add_sampling(Report& report) {
    constexpr double call = 12, batch = 6;
    const std::vector<Named> designs = sampled_designs();
    for (const Named& d : designs)
        add(report, fmt::format("visible facet, call: {} against caps", d.name), d.design, call,
            [](const Brdf& brdf, const std::vector<dvec3>& ks, Random& random) {
                for (const dvec3 k : ks)
                    benchmark::DoNotOptimize(brdf.tables().distribution->sample_visible(k, random));
            });
    for (const Named& d : designs)
        add(report, fmt::format("BRDF sample, weight and pdf, call: {} against caps", d.name), d.design, call,
            [](const Brdf& brdf, const std::vector<dvec3>& ks, Random& random) {
                for (const dvec3 k : ks) benchmark::DoNotOptimize(brdf.sample(k, random));
            });
    for (const Named& d : designs)
        add(report, fmt::format("BRDF sample, weight and pdf, batch: {} against caps", d.name), d.design,
            batch,
            [samples = std::vector<BrdfSample>(count)](const Brdf& brdf, const std::vector<dvec3>& ks,
                                                       Random& random) mutable {
                sample_directions(brdf, ks, random, samples);
                benchmark::DoNotOptimize(samples.data());
            });
}

}  // namespace nacre::bench
