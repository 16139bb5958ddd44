#include "core/verify/facet_oracle.h"

#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double tolerance = 1e-6;  // of V

}  // namespace

FacetOracle::FacetOracle(const Reference& reference)
    : reference_(reference), product_(reference.distribution()) {}

double FacetOracle::area(dvec3 k) const {
    const Shading<double>& shading = reference_.shading();
    const double g = reference_.projected_area(k);
    return shading.kinds.clamp ? std::max(g, shading.surface.N * k.z) : g;
}

double FacetOracle::product(dvec3 k1, dvec3 k2, const std::stop_token& stop) const {
    const double N = reference_.shading().surface.N, both = area(k1) * area(k2);
    return both > 0 ? N * product_(k1, k2, tolerance * both / N, stop) / both : 0;
}

WalkEstimate FacetOracle::later_bounces(dvec3 k1, dvec3 k2, const WalkEffort& effort,
                                        const std::stop_token& stop) const {
    const Shading<double>& shading = reference_.shading();
    const dvec3 albedo = shading.surface.albedo;
    return over_walks(
        k1, effort, stop, [&](const std::vector<dvec3>& from, Random& random, std::vector<dvec3>& scores) {
            FacetWalks walks(
                reference_.distribution(), facet_walk(static_cast<std::size_t>(shading.kinds.masking)),
                shading.surface.N, [this](dvec3 k) { return reference_.projected_area(k); },
                FacetScatter::matt);
            walks.enter(from, random);
            for (int order = 1; order <= effort.last && !walks.inside().empty() && !stop.stop_requested();
                 ++order)
                walks.bounce(
                    random,
                    [&](FacetWalks::Walk& walk, dvec3 h) {
                        walk.weight *= albedo;
                        const double cosine = glm::dot(h, k2);
                        if (order >= std::max(effort.first, 2) && cosine > 0)
                            scores[walk.index] += walk.weight * (cosine / pi * walks.way_out(walk, k2));
                        survive(walk, order, random);
                    },
                    [](const FacetWalks::Walk&, dvec3) {});
        });
}

WalkEstimate FacetOracle::rho(dvec3 k1, dvec3 k2, const WalkEffort& effort,
                              const std::stop_token& stop) const {
    if (k1.z <= 0 || k2.z <= 0) return {};
    const Shading<double>& shading = reference_.shading();
    WalkEstimate sum;
    if (effort.last > 1) sum = later_bounces(k1, k2, effort, stop);
    if (effort.first <= 1) {
        const double masked =
                         shading.visibility(reference_.direction(k1, stop), reference_.direction(k2, stop)),
                     plain = shading.surface.N / (area(k1) * area(k2));
        sum.mean += dvec3{shading.surface.albedo} * (masked / plain * product(k1, k2, stop) / pi);
    }
    return {sum.mean * shading.surface.kd, sum.error * shading.surface.kd};
}

}  // namespace nacre
