#include "core/verify/sampling_check.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/verify/effort.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

constexpr int samples = 16384;  // the mean's standard error is below 0.004 where weights are at most 1
constexpr int directions = 8, least_directions = 4;
constexpr double seconds = 8;  // of the processor

// The specular term alone, as it is beneath a coat, unweighted, so that every sample is a visible facet.
std::shared_ptr<const Tables> specular_only(const Tables& tables) {
    auto specular = std::make_shared<Tables>();
    specular->needs = tables.needs;
    specular->size = tables.size;
    specular->distribution = tables.distribution;
    specular->data = tables.data;
    specular->shading = tables.shading;
    specular->shading.data = specular->data.data();
    specular->shading.kinds.diffuse = kind_index<Diffuse, NoDiffuse>();
    specular->shading.kinds.multibounce = kind_index<Multibounce, NoMultibounce>();
    specular->shading.kinds.coat = kind_index<Coat, NoCoat>();
    specular->shading.surface.ks = 1;
    return specular;
}

SamplingCheck sample_at(const Brdf& brdf, dvec3 k, dvec3 albedo, Random random, const std::stop_token& stop) {
    SamplingCheck check{.weight = -1};
    const BrdfSampler sampler(brdf, k);
    dvec3 sum{0};
    for (int i = 0; i < samples; ++i) {
        if (i % 256 == 0 && stop.stop_requested()) throw BakeCancelled();
        const auto sample = sampler(random);
        if (!sample) continue;
        sum += sample->weight;
        const Shading<double>& shading = brdf.tables().shading;
        dvec3 f = shading.fresnel(shading.half_vector(k, sample->k2).cosine);
        if (shading.kinds.retro)
            f = glm::max(f, shading.fresnel(shading.half_vector(shading.turned(k), sample->k2).cosine));
        for (int c = 0; c < 3; ++c)
            if (f[c] > 0) check.weight = worse_error(check.weight, sample->weight[c] / f[c] - 1);
    }
    for (int c = 0; c < 3; ++c) check.mean = worse_error(check.mean, std::fabs(sum[c] / samples - albedo[c]));
    return check;
}

}  // namespace

SamplingCheck measure_sampling(const Tables& tables, std::stop_token stop) {
    const Brdf specular(specular_only(tables));
    const std::vector<dvec3> probes = probe_directions(directions);
    std::vector<SamplingCheck> parts(probes.size());
    SamplingCheck worst{.weight = -1};
    worst.directions = visit_within(seconds, directions, least_directions, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        parts[at] = sample_at(specular, probes[at], specular.albedo(probes[at]), Random(at), stop);
    });
    parts.resize(static_cast<std::size_t>(worst.directions));
    for (const SamplingCheck& part : parts) {
        worst.weight = worse_error(worst.weight, part.weight);
        worst.mean = worse_error(worst.mean, part.mean);
    }
    return worst;
}

}  // namespace nacre
