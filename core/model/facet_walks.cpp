#include "core/model/facet_walks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/limits.h"
#include "core/model/visible_facets.h"

namespace nacre {
namespace {

// -ln of a number in (0, 1].
double exponential(Random& random) { return -std::log(1 - uniform_random(random)); }

}  // namespace

FacetWalks::FacetWalks(const FacetDistribution& distribution, FacetWalk kind, double N, Area g)
    : distribution_(distribution), kind_(kind), N_(N), g_(std::move(g)) {}

void FacetWalks::enter(std::span<const dvec3> k1, Random& random) {
    walks_.clear();
    for (std::size_t i = 0; i < k1.size(); ++i) {
        const double g = kind_ == FacetWalk::smith ? g_(k1[i]) : 0;
        const double depth = g > 0 ? exponential(random) * k1[i].z * N_ / g : 0;
        walks_.push_back({k1[i], depth, dvec3{1}, i});
    }
}

// d: where a facet has sent the light. If it stays inside, the walk goes on from there.
bool FacetWalks::leaves(Walk& walk, dvec3 d, Random& random) const {
    if (kind_ == FacetWalk::uncorrelated) {
        if (d.z > 0 && uniform_random(random) * g_(d) < N_ * d.z) return true;
    } else {
        const double g = g_(-d);
        const double free = g > 0 ? exponential(random) * N_ / g : limits::infinity;
        const double depth = walk.depth - d.z * free;
        if (d.z > 0 && depth <= 0) return true;
        walk.depth = std::isfinite(depth) ? depth : walk.depth;
    }
    walk.view = -d;
    return false;
}

void FacetWalks::bounce(Random& random, const Reflect& reflect, const Leave& leave) {
    views_.clear();
    for (const Walk& walk : walks_) views_.push_back(walk.view);
    facets_.resize(views_.size());
    distribution_.visible_facets().draw(views_, random, facets_);
    std::size_t left = 0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        Walk walk = walks_[i];
        const dvec3 h = facets_[i];
        if (h == dvec3{0}) continue;
        reflect(walk, h);
        const dvec3 d = glm::normalize(2 * glm::dot(walk.view, h) * h - walk.view);
        if (leaves(walk, d, random)) {
            leave(walk, d);
        } else {
            walks_[left++] = walk;
        }
    }
    walks_.resize(left);
}

double FacetWalks::next_event(const Walk& walk, dvec3 k2, double p) const {
    const double g = g_(walk.view);
    if (!(g > 0) || !(p > 0)) return 0;
    const double out = kind_ == FacetWalk::uncorrelated
                           ? N_ / std::max(g_(k2), N_ * k2.z)
                           : std::exp(-walk.depth * g_(-k2) / (N_ * k2.z)) / k2.z;
    return p / (4 * g) * out;
}

}  // namespace nacre
