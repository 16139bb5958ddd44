// Visible facets of one direction, in double and with the same random numbers: Nacre's samplers against
// spherical caps of GGX.
#include <fmt/core.h>

#include "core/bake/brdf.h"
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

template <class Ours>
void add(Report& report, const std::string& what, const Design& design, const Ours& make_ours) {
    add_benchmark(what, repetitions, [=, &report](benchmark::State& state) {
        const Brdf brdf(bake(design));
        const auto ours = make_ours(brdf);
        const SphericalCap caps{{0.1, 0.3}};
        Random directions(13), random(17);
        std::vector<dvec3> ks;
        for (std::size_t i = 0; i < count; ++i)
            ks.push_back(test::polar(1 - uniform_random(directions), 2 * pi * uniform_random(directions)));
        const auto each = [&](const auto& sample) {
            for (const dvec3 k : ks) benchmark::DoNotOptimize(sample(k, random));
        };
        const Pair pair = interleave(
            state, count, [&] { each(ours); }, [&] { each(caps); });
        report.add(compared(what, pair));
    });
}

}  // namespace

void add_sampling(Report& report) {
    struct Named {
        const char* name;
        Design design;
    };
    for (const Named& d : {Named{"GGX (0.1, 0.3)", test::design_of(GgxLobe{0.1, 0.3})},
                           Named{"Gaussian (0.1, 1)", brushed()}, Named{"painted 512", painted(512)}}) {
        add(report, fmt::format("visible facet of {} against caps", d.name), d.design, [](const Brdf& brdf) {
            return [&](dvec3 k, Random& random) {
                return brdf.tables().distribution->sample_visible(k, random);
            };
        });
        add(report, fmt::format("BRDF sample, weight and pdf of {} against caps", d.name), d.design,
            [](const Brdf& brdf) { return [&](dvec3 k, Random& random) { return brdf.sample(k, random); }; });
    }
}

}  // namespace nacre::bench
