#include "core/verify/bounce_oracle.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nacre {
namespace {

// The masking that the first bounce of such walks is.
int own_masking(FacetWalk walk) {
    return walk == FacetWalk::smith ? kind_index<MaskingModel, SmithCorrelatedMasking>()
                                    : kind_index<MaskingModel, UncorrelatedMasking>();
}

}  // namespace

BounceOracle::BounceOracle(const Reference& reference)
    : reference_(reference), walk_(facet_walk(static_cast<std::size_t>(reference.shading().kinds.masking))) {}

dvec3 BounceOracle::reflectance(dvec3 h, double cosine) const {
    const Shading<double>& shading = reference_.shading();
    const dvec3 f = shading.fresnel(std::min(cosine, 1.0));
    return shading.kinds.tint == Tint::none ? f : f * shading.facet_tint(h, shading.density(h));
}

template <class Before, class Leave>
WalkEstimate BounceOracle::over_bounces(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop,
                                        const Before& before, const Leave& leave) const {
    return over_walks(
        k1, effort, stop, [&](const std::vector<dvec3>& from, Random& random, std::vector<dvec3>& scores) {
            FacetWalks walks(reference_.distribution(), walk_, reference_.shading().surface.N,
                             [this](dvec3 k) { return reference_.projected_area(k); });
            walks.enter(from, random);
            for (int order = 1; order <= effort.last && !walks.inside().empty() && !stop.stop_requested();
                 ++order) {
                const bool counts = order >= effort.first;
                if (counts) before(walks, scores);
                walks.bounce(
                    random,
                    [&](FacetWalks::Walk& walk, dvec3 h) {
                        walk.weight *= reflectance(h, glm::dot(walk.view, h));
                        survive(walk, order, random);
                    },
                    [&](const FacetWalks::Walk& walk, dvec3) {
                        if (counts) leave(walk, scores);
                    });
            }
        });
}

WalkEstimate BounceOracle::forward_albedo(dvec3 k1, const WalkEffort& effort,
                                          const std::stop_token& stop) const {
    if (k1.z <= 0) return {};
    const WalkEstimate result = over_bounces(
        k1, effort, stop, [](const FacetWalks&, std::vector<dvec3>&) {},
        [](const FacetWalks::Walk& walk, std::vector<dvec3>& scores) { scores[walk.index] += walk.weight; });
    const double factor = scale(k1, stop);
    return {result.mean * factor, result.error * factor};
}

WalkEstimate BounceOracle::forward_rho(dvec3 k1, dvec3 k2, const WalkEffort& effort,
                                       const std::stop_token& stop) const {
    if (k1.z <= 0 || k2.z <= 0) return {};
    const auto toward_k2 = [&](const FacetWalks& walks, std::vector<dvec3>& scores) {
        for (const FacetWalks::Walk& walk : walks.inside()) {
            const auto between = reference_.shading().half_vector(walk.view, k2);
            const double cosine = glm::dot(walk.view, between.h);
            if (!between.exists || cosine <= 0) continue;
            const double p = reference_.distribution().density(between.h);
            if (p > 0)
                scores[walk.index] +=
                    walk.weight * walks.next_event(walk, k2, p) * reflectance(between.h, cosine);
        }
    };
    const WalkEstimate result =
        over_bounces(k1, effort, stop, toward_k2, [](const FacetWalks::Walk&, std::vector<dvec3>&) {});
    const double factor = std::sqrt(scale(k1, stop) * scale(k2, stop));
    return {result.mean * factor, result.error * factor};
}

WalkEstimate BounceOracle::rho(dvec3 k1, dvec3 k2, const WalkEffort& effort,
                               const std::stop_token& stop) const {
    const WalkEstimate forward = forward_rho(k1, k2, effort, stop);
    const Shading<double>& shading = reference_.shading();
    if (!shading.kinds.retro) return forward;
    const WalkEstimate back = mixed(0.5, forward_rho(shading.turned(k1), k2, effort, stop),
                                    forward_rho(k1, shading.turned(k2), effort, stop));
    return mixed(shading.surface.retro, forward, back);
}

WalkEstimate BounceOracle::albedo(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop) const {
    const WalkEstimate forward = forward_albedo(k1, effort, stop);
    const Shading<double>& shading = reference_.shading();
    if (!shading.kinds.retro) return forward;
    return mixed(0.5 * shading.surface.retro, forward, forward_albedo(shading.turned(k1), effort, stop));
}

// 1 - E under a masking, tints left out.
double BounceOracle::rest(dvec3 k, int masking, const std::stop_token& stop) const {
    Shading<double> white = reference_.shading();
    white.kinds.masking = masking;
    white.kinds.tint = Tint::none;
    const AdaptiveAlbedo albedo(reference_.distribution(), 1e-6);
    const auto area = [this](dvec3 k2) { return reference_.projected_area(k2); };
    return 1 - albedo({white, k, area(k), 0}, area, stop)[0];
}

// What this masking leaves over what the walks' own leaves.
double BounceOracle::scale(dvec3 k, const std::stop_token& stop) const {
    const int masking = reference_.shading().kinds.masking, own = own_masking(walk_);
    if (masking == own) return 1;
    const double walks = rest(k, own, stop);
    return walks > 1e-9 ? std::max(rest(k, masking, stop), 0.0) / walks : 1;
}

}  // namespace nacre
