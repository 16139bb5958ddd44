#include "core/study/brdf_time.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/bake/brdf_pairs.h"
#include "core/base/stopwatch.h"
#include "core/model/float_shading.h"
#include "core/study/paper_designs.h"
#include "core/study/ward.h"

namespace nacre {
namespace {

using glm::vec3;

constexpr std::size_t count = 4096;
constexpr int repetitions = 101;
constexpr vec3 gold{1.0f, 0.71f, 0.29f};

struct Pairs {
    std::vector<vec3> k1, k2;
};

Pairs random_pairs(const FacetDistribution& facets) {
    Random random(7);
    Pairs pairs;
    while (pairs.k1.size() < count) {
        const dvec3 k1 = cosine_sample(random);
        const dvec3 k2 =
            pairs.k1.size() % 2 ? mirrored(k1, facets.sample_visible(k1, random)) : cosine_sample(random);
        if (k1.z <= 0 || k2.z <= 0) continue;
        pairs.k1.emplace_back(k1);
        pairs.k2.emplace_back(k2);
    }
    return pairs;
}

Shading<float>::ClosedForm in_float(const Shading<double>::ClosedForm& form) {
    Shading<float>::ClosedForm made{};
    made.axis = form.axis;
    made.width = form.width;
    made.inverse_width = form.inverse_width;
    made.scale = static_cast<float>(form.scale);
    return made;
}

// As a renderer would call it: reciprocals taken once.
struct Ward {
    vec3 operator()(vec3 k1, vec3 k2) const {
        if (k1.z <= 0 || k2.z <= 0) return vec3(0);
        const float cosine = std::min(0.5f * glm::length(k1 + k2), 1.0f);
        return Shading<float>::schlick_fresnel(gold, vec3(0), cosine) * Shading<float>::ward(form, k1, k2);
    }
    Shading<float>::ClosedForm form;
};

struct Ours {
    vec3 operator()(vec3 k1, vec3 k2) const { return shading.brdf(k1, k2); }
    const Shading<float>& shading;
};

struct Density {
    vec3 operator()(vec3 k1, vec3 k2) const { return vec3(shading.density(glm::normalize(k1 + k2))); }
    const Shading<float>& shading;
};

template <class Brdf>
[[gnu::noinline]] vec3 call(const Brdf& brdf, vec3 k1, vec3 k2) {
    return brdf(k1, k2);
}

template <class Brdf>
void call_each(const Brdf& brdf, const Pairs& pairs, std::vector<vec3>& values) {
    for (std::size_t i = 0; i < count; ++i) values[i] = call(brdf, pairs.k1[i], pairs.k2[i]);
}

template <class Brdf>
[[gnu::noinline, gnu::flatten]] void loop(const Brdf& brdf, const Pairs& pairs, std::vector<vec3>& values) {
    for (std::size_t i = 0; i < count; ++i) values[i] = brdf(pairs.k1[i], pairs.k2[i]);
}

template <class Work>
double seconds_of(const Work& work) {
    const Stopwatch watch;
    work();
    return watch.seconds();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + repetitions / 2, values.end());
    return values[repetitions / 2];
}

}  // namespace

BrdfTimes time_brdf(const std::stop_token& stop) {
    Design design = paper_gaussian(0.1, 1);
    design.fresnel = SchlickFresnel{dvec3(gold)};
    const auto tables = bake(design, {}, stop);
    const Shading<float> shading = nacre::in_float(tables->shading);
    const Ward ward{in_float(ward_form({0.1, 1}))};
    const Ours ours{shading};
    const Density density{shading};
    const Pairs pairs = random_pairs(*tables->distribution);
    std::vector<vec3> values(count);
    std::array<std::vector<double>, 5> seconds;
    // In turn, so that a busy machine hits all alike.
    for (int run = 0; run < repetitions; ++run) {
        if (stop.stop_requested()) throw BakeCancelled();
        seconds[0].push_back(seconds_of([&] { call_each(ward, pairs, values); }));
        seconds[1].push_back(seconds_of([&] { call_each(ours, pairs, values); }));
        seconds[2].push_back(seconds_of([&] { loop(ward, pairs, values); }));
        seconds[3].push_back(seconds_of([&] { evaluate_pairs(shading, pairs.k1, pairs.k2, values); }));
        seconds[4].push_back(seconds_of([&] { call_each(density, pairs, values); }));
    }
    const double theirs = median(seconds[0]), called = median(seconds[1]);
    return {theirs / count, called / theirs, median(seconds[3]) / median(seconds[2]),
            median(seconds[4]) / called};
}

}  // namespace nacre
