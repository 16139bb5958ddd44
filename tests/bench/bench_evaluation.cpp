// The BRDF of one pair of directions, in float: Nacre's shared mathematics with its tables, against closed
// forms. "call": one call a pair, as a renderer makes it. "loop": everything inlined into a loop over arrays.
// "batch": ours evaluates all pairs at once, theirs is the loop, which the compiler may make vectors of.
#include <fmt/core.h>

#include "core/bake/brdf_pairs.h"
#include "core/model/float_shading.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/closed_form_brdf.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

constexpr std::size_t count = 4096;
constexpr int repetitions = 301;
constexpr vec3 f0{1.0f, 0.71f, 0.29f};

struct Pairs {
    std::vector<vec3> k1, k2;
};

// Half of them anywhere above the horizon, half about the highlight: mirrored at a facet that k1 sees.
Pairs random_pairs(const FacetDistribution& facets) {
    Random random(7);
    const auto anywhere = [&] {
        return test::polar(1 - uniform_random(random), 2 * std::numbers::pi * uniform_random(random));
    };
    Pairs pairs;
    while (pairs.k1.size() < count) {
        const dvec3 k1 = anywhere();
        dvec3 k2 = anywhere();
        if (pairs.k1.size() % 2) {
            const dvec3 h = facets.sample_visible(k1, random);
            k2 = glm::normalize(2 * glm::dot(k1, h) * h - k1);
            if (k2.z <= 0) continue;
        }
        pairs.k1.emplace_back(k1);
        pairs.k2.emplace_back(k2);
    }
    return pairs;
}

struct Nacre {
    vec3 operator()(vec3 k1, vec3 k2) const { return shading.brdf(k1, k2); }
    Shading<float> shading;
};

template <class Brdf>
[[gnu::noinline]] vec3 call(const Brdf& brdf, vec3 k1, vec3 k2) {
    return brdf(k1, k2);
}

template <class Brdf>
[[gnu::noinline]] void call_each(const Brdf& brdf, const Pairs& pairs, std::vector<vec3>& values) {
    for (std::size_t i = 0; i < count; ++i) values[i] = call(brdf, pairs.k1[i], pairs.k2[i]);
    benchmark::DoNotOptimize(values.data());
}

template <class Brdf>
[[gnu::noinline, gnu::flatten]] void loop(const Brdf& brdf, const Pairs& pairs, std::vector<vec3>& values) {
    const vec3 *k1 = pairs.k1.data(), *k2 = pairs.k2.data();
    vec3* value = values.data();
    for (std::size_t i = 0; i < count; ++i) value[i] = brdf(k1[i], k2[i]);
    benchmark::DoNotOptimize(value);
}

enum class Manner { call, loop, batch };

const char* name_of(Manner manner) {
    return manner == Manner::call ? "call" : manner == Manner::loop ? "loop" : "batch";
}

template <class Brdf>
void run(Manner manner, const Brdf& brdf, const Pairs& pairs, std::vector<vec3>& values) {
    manner == Manner::call ? call_each(brdf, pairs, values) : loop(brdf, pairs, values);
}

void run(Manner manner, const Nacre& ours, const Pairs& pairs, std::vector<vec3>& values) {
    if (manner != Manner::batch) return run<Nacre>(manner, ours, pairs, values);
    evaluate_pairs(ours.shading, pairs.k1, pairs.k2, values);
}

template <class Brdf>
void add(Report& report, const std::string& name, const Design& design, const std::string& other,
         const Brdf& theirs, double wanted) {
    for (const Manner manner : {Manner::call, Manner::loop, Manner::batch}) {
        const std::string what = fmt::format("BRDF, {}: {} against {}", name_of(manner), name, other);
        add_benchmark(what, repetitions, [=, &report](benchmark::State& state) {
            Design schlick = design;
            schlick.fresnel = SchlickFresnel{f0};
            const auto tables = bake(schlick);
            const Nacre ours{in_float(tables->shading)};
            const Pairs pairs = random_pairs(*tables->distribution);
            std::vector<vec3> values(count);
            const Pair pair = interleave(
                state, count, [&] { run(manner, ours, pairs, values); },
                [&] { run(manner, theirs, pairs, values); });
            report.add(at_most_times(what, pair, wanted));
        });
    }
}

}  // namespace

void add_evaluation(Report& report) {
    const Ward ward{closed_form(0.1f, 1.0f), f0};
    const GgxSmith ggx{closed_form(0.1f, 0.3f), f0};
    const CookTorrance cook_torrance{closed_form(0.2f, 0.2f), f0};
    struct Named {
        const char* name;
        Design design;
        double wanted;
    };
    const Named designs[] = {{"Gaussian (0.1, 1)", brushed(), 1.5},
                             {"GGX (0.1, 0.3)", test::design_of(GgxLobe{0.1, 0.3}), 1.5},
                             {"painted 512", painted(512), 2.5}};
    for (const Named& d : designs) {
        add(report, d.name, d.design, "Ward", ward, d.wanted);
        add(report, d.name, d.design, "GGX-Smith", ggx, d.wanted);
        add(report, d.name, d.design, "Cook-Torrance", cook_torrance, d.wanted);
    }
}

}  // namespace nacre::bench
