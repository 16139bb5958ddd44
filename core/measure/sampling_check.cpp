#include "core/measure/sampling_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/measure/table_error.h"

namespace nacre {
namespace {

constexpr int samples = 16384;  // the mean's standard error is below 0.004 where weights are at most 1
constexpr int directions = 8;

// The specular term alone, unweighted, so that every sample is a visible facet.
Design specular_only(Design design) {
    design.diffuse = NoDiffuse{};
    return design;
}

SamplingCheck sample_at(const Brdf& brdf, dvec3 k, dvec3 albedo, Random random, const std::stop_token& stop) {
    SamplingCheck check{.weight = -1};
    dvec3 sum{0};
    for (int i = 0; i < samples; ++i) {
        if (i % 256 == 0 && stop.stop_requested()) throw BakeCancelled();
        const auto sample = brdf.sample(k, random);
        if (!sample) continue;
        sum += sample->weight;
        const double cosine = std::fmin(0.5 * glm::length(k + sample->k2), 1.0);
        const dvec3 f = brdf.tables().shading.fresnel(cosine);
        for (int c = 0; c < 3; ++c)
            if (f[c] > 0) check.weight = worse_error(check.weight, sample->weight[c] / f[c] - 1);
    }
    for (int c = 0; c < 3; ++c) check.mean = worse_error(check.mean, std::fabs(sum[c] / samples - albedo[c]));
    return check;
}

}  // namespace

SamplingCheck measure_sampling(const Design& design, std::shared_ptr<const Tables> tables,
                               std::stop_token stop) {
    const Brdf whole(std::move(tables)), specular(bake(specular_only(design), {}, stop));
    const std::vector<dvec3> probes = probe_directions(directions);
    std::vector<SamplingCheck> parts(probes.size());
    tbb::parallel_for(std::size_t{0}, probes.size(), [&](std::size_t i) {
        parts[i] = sample_at(specular, probes[i], whole.albedo(probes[i]), Random(i), stop);
    });
    SamplingCheck worst{.weight = -1};
    for (const SamplingCheck& part : parts) {
        worst.weight = worse_error(worst.weight, part.weight);
        worst.mean = worse_error(worst.mean, part.mean);
    }
    return worst;
}

}  // namespace nacre
