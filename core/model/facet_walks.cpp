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

FacetWalks::FacetWalks(const FacetDistribution& distribution, FacetWalk kind, double N, Area g,
                       FacetScatter scatter)
    : distribution_(distribution), kind_(kind), N_(N), g_(std::move(g)), scatter_(scatter) {}

void FacetWalks::enter(std::span<const dvec3> k1, Random& random) {
    walks_.clear();
    for (std::size_t i = 0; i < k1.size(); ++i) {
        const double g = kind_ == FacetWalk::smith ? g_(k1[i]) : 0;
        const double depth = g > 0 ? exponential(random) * k1[i].z * N_ / g : 0;
        walks_.push_back({k1[i], depth, dvec3{1}, i});
    }
}

dvec3 FacetWalks::scattered(dvec3 view, dvec3 h, Random& random) const {
    if (scatter_ == FacetScatter::mirror) return glm::normalize(2 * glm::dot(view, h) * h - view);
    // Duff et al. 2017: any two axes at right angles to h.
    const dvec3 own = cosine_sample(random);
    const double sign = std::copysign(1.0, h.z), a = -1 / (sign + h.z), b = h.x * h.y * a;
    const dvec3 x{1 + sign * h.x * h.x * a, sign * b, -sign * h.x}, y{b, sign + h.y * h.y * a, -h.y};
    return glm::normalize(own.x * x + own.y * y + own.z * h);
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
        const dvec3 d = scattered(walk.view, h, random);
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
    return p / (4 * g) * way_out(walk, k2);
}

double FacetWalks::way_out(const Walk& walk, dvec3 k2) const {
    return kind_ == FacetWalk::uncorrelated ? N_ / std::max(g_(k2), N_ * k2.z)
                                            : std::exp(-walk.depth * g_(-k2) / (N_ * k2.z)) / k2.z;
}

}  // namespace nacre
