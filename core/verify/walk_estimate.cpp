#include "core/verify/walk_estimate.h"

#include <cmath>

namespace nacre {
namespace {

// From here on only every other walk goes on, with twice the weight, where its weight is below a quarter of
// what went in: light that is all but absorbed.
constexpr double weak = 0.25;
// And this part of all walks each bounce, once so many are behind them: a p that is nearly a whole sphere's
// keeps light for thousands.
constexpr int long_walk = 256;
constexpr double survival = 0.98;

}  // namespace

WalkEstimate estimate(const std::vector<WalkScores>& parts, int walks) {
    WalkScores all;
    for (const WalkScores& part : parts) {
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

WalkEstimate mixed(double part, const WalkEstimate& a, const WalkEstimate& b) {
    WalkEstimate sum{(1 - part) * a.mean + part * b.mean, dvec3{0}};
    for (int c = 0; c < 3; ++c) sum.error[c] = std::hypot((1 - part) * a.error[c], part * b.error[c]);
    return sum;
}

void survive(FacetWalks::Walk& walk, int order, Random& random) {
    const double largest = std::max({walk.weight.x, walk.weight.y, walk.weight.z});
    const double chance = largest < weak ? 0.5 : order > long_walk ? survival : 1;
    if (chance < 1) walk.weight = uniform_random(random) < chance ? walk.weight / chance : dvec3{0};
}

}  // namespace nacre
