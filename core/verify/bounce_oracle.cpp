#include "core/verify/bounce_oracle.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bake/workers.h"
#include "core/model/facet_walks.h"

namespace nacre {
namespace {

constexpr int walks_at_once = 1024;

// From here on only every other walk goes on, with twice the weight, where its weight is below a quarter of
// what went in: light that is all but absorbed.
constexpr double weak = 0.25;
// And this part of all walks each bounce, once so many are behind them: a p that is nearly a whole sphere's
// keeps light for thousands.
constexpr int long_walk = 256;
constexpr double survival = 0.98;

double largest(dvec3 v) { return std::max({v.x, v.y, v.z}); }

// Sums of what each walk scores, and of the squares.
struct Scores {
    dvec3 sum{0}, squares{0};

    void add(dvec3 score) {
        sum += score;
        squares += score * score;
    }
};

WalkEstimate estimate(const std::vector<Scores>& parts, int walks) {
    Scores all;
    for (const Scores& part : parts) {
        all.sum += part.sum;
        all.squares += part.squares;
    }
    const double count = walks;
    WalkEstimate result{all.sum / count, dvec3{0}};
    for (int c = 0; c < 3; ++c)
        result.error[c] = std::sqrt(std::max(all.squares[c] / count - result.mean[c] * result.mean[c], 0.0) /
                                    std::max(count - 1, 1.0));
    return result;
}

// (1 - part) a + part b.
WalkEstimate mixed(double part, const WalkEstimate& a, const WalkEstimate& b) {
    WalkEstimate sum{(1 - part) * a.mean + part * b.mean, dvec3{0}};
    for (int c = 0; c < 3; ++c) sum.error[c] = std::hypot((1 - part) * a.error[c], part * b.error[c]);
    return sum;
}

// Walks of light from k1, some at a time. see(walk, order) before each bounce, leave(walk, order) where light
// comes out, score at a walk's index.
template <class Visit>
WalkEstimate over_walks(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop, const Visit& visit) {
    const int count = (effort.walks + walks_at_once - 1) / walks_at_once;
    std::vector<Scores> parts(static_cast<std::size_t>(count));
    tbb::parallel_for(0, count, [&](int i) {
        Random random((effort.seed << 32) + static_cast<std::uint64_t>(i));
        const int some = std::min(walks_at_once, effort.walks - i * walks_at_once);
        std::vector<dvec3> scores(static_cast<std::size_t>(some));
        if (stop.stop_requested()) return;
        visit(std::vector<dvec3>(scores.size(), k1), random, scores);
        for (const dvec3 score : scores) parts[static_cast<std::size_t>(i)].add(score);
    });
    if (stop.stop_requested()) throw BakeCancelled();
    return estimate(parts, effort.walks);
}

// Of a walk that goes on, whether it does.
void survive(FacetWalks::Walk& walk, int order, Random& random) {
    const double chance = largest(walk.weight) < weak ? 0.5 : order > long_walk ? survival : 1;
    if (chance < 1) walk.weight = uniform_random(random) < chance ? walk.weight / chance : dvec3{0};
}

}  // namespace

BounceOracle::BounceOracle(const Reference& reference)
    : reference_(reference),
      scaled_(reference.shading().kinds.masking == kind_index<MaskingModel, CorrelatedMasking>()) {}

dvec3 BounceOracle::reflectance(dvec3 h, double cosine) const {
    const Shading<double>& shading = reference_.shading();
    const dvec3 f = shading.fresnel(std::min(cosine, 1.0));
    return shading.kinds.tint == Tint::none ? f : f * shading.facet_tint(h, shading.density(h));
}

WalkEstimate BounceOracle::forward_albedo(dvec3 k1, const WalkEffort& effort,
                                          const std::stop_token& stop) const {
    if (k1.z <= 0) return {};
    const Shading<double>& shading = reference_.shading();
    WalkEstimate result = over_walks(
        k1, effort, stop, [&](const std::vector<dvec3>& from, Random& random, std::vector<dvec3>& scores) {
            FacetWalks walks(reference_.distribution(),
                             facet_walk(static_cast<std::size_t>(shading.kinds.masking)), shading.surface.N,
                             [this](dvec3 k) { return reference_.projected_area(k); });
            walks.enter(from, random);
            for (int order = 1; order <= effort.last && !walks.inside().empty() && !stop.stop_requested();
                 ++order)
                walks.bounce(
                    random,
                    [&](FacetWalks::Walk& walk, dvec3 h) {
                        walk.weight *= reflectance(h, glm::dot(walk.view, h));
                        survive(walk, order, random);
                    },
                    [&](const FacetWalks::Walk& walk, dvec3) {
                        if (order >= effort.first) scores[walk.index] += walk.weight;
                    });
        });
    const double factor = scale(k1, stop);
    return {result.mean * factor, result.error * factor};
}

WalkEstimate BounceOracle::forward_rho(dvec3 k1, dvec3 k2, const WalkEffort& effort,
                                       const std::stop_token& stop) const {
    if (k1.z <= 0 || k2.z <= 0) return {};
    const Shading<double>& shading = reference_.shading();
    WalkEstimate result = over_walks(
        k1, effort, stop, [&](const std::vector<dvec3>& from, Random& random, std::vector<dvec3>& scores) {
            FacetWalks walks(reference_.distribution(),
                             facet_walk(static_cast<std::size_t>(shading.kinds.masking)), shading.surface.N,
                             [this](dvec3 k) { return reference_.projected_area(k); });
            walks.enter(from, random);
            for (int order = 1; order <= effort.last && !walks.inside().empty() && !stop.stop_requested();
                 ++order) {
                if (order >= effort.first)
                    for (const FacetWalks::Walk& walk : walks.inside()) {
                        const auto between = shading.half_vector(walk.view, k2);
                        const double cosine = glm::dot(walk.view, between.h);
                        if (!between.exists || cosine <= 0) continue;
                        const double p = reference_.distribution().density(between.h);
                        if (p > 0)
                            scores[walk.index] +=
                                walk.weight * walks.next_event(walk, k2, p) * reflectance(between.h, cosine);
                    }
                walks.bounce(
                    random,
                    [&](FacetWalks::Walk& walk, dvec3 h) {
                        walk.weight *= reflectance(h, glm::dot(walk.view, h));
                        survive(walk, order, random);
                    },
                    [](const FacetWalks::Walk&, dvec3) {});
            }
        });
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
    if (!scaled_) return 1;
    const double walks = rest(k, kind_index<MaskingModel, UncorrelatedMasking>(), stop);
    return walks > 1e-9 ? std::max(rest(k, reference_.shading().kinds.masking, stop), 0.0) / walks : 1;
}

}  // namespace nacre
