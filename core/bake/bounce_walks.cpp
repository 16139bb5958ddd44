#include "core/bake/bounce_walks.h"

#include <algorithm>
#include <cmath>

#include "core/model/facet_walks.h"

namespace nacre {
namespace {

constexpr int walks_at_once = 1024;

// Where p is nearly a whole sphere's light leaves after thousands of bounces; what has not left after so many
// is left out of the shape of what comes back, not of its sum.
constexpr int bounces_max = 400;

// Of all walks of a set: fewer walks where each is long.
constexpr double bounces_in_all = 1.5e6;

// What one walk met between its first bounce and its last.
struct Met {
    dvec3 tint{0}, schlick{0}, fresnel{0};

    Met& operator+=(const Met& other) {
        tint += other.tint;
        schlick += other.schlick;
        fresnel += other.fresnel;
        return *this;
    }
};

struct Part {
    std::vector<BouncePair> pairs;
    int bounces = 0;
    int second = 0;
    int between = 0;  // bounces that `met` sums over
    Met met;
};

class Walker {
  public:
    Walker(const Shading<double>& shading, const FacetDistribution& distribution)
        : shading_(shading), distribution_(distribution), mean_(distribution.mean()) {}

    Part operator()(int count, std::uint64_t seed) const {
        Random random(seed);
        std::vector<dvec3> from;
        for (int i = 0; i < count; ++i) from.push_back(cosine_sample(random));
        FacetWalks walks(distribution_, facet_walk(static_cast<std::size_t>(shading_.kinds.masking)),
                         shading_.surface.N, [this](dvec3 k) { return area_everywhere(shading_, mean_, k); });
        walks.enter(from, random);
        Part part;
        std::vector<Met> before(from.size()), last(from.size());
        for (int order = 1; order <= bounces_max && !walks.inside().empty(); ++order)
            walks.bounce(
                random,
                [&](const FacetWalks::Walk& walk, dvec3 h) {
                    ++part.bounces;
                    if (order < 2) return;
                    before[walk.index] += last[walk.index];
                    last[walk.index] = met(walk, h);
                },
                [&](const FacetWalks::Walk& walk, dvec3 k2) {
                    if (order < 2) return;
                    part.pairs.push_back({from[walk.index], k2});
                    part.second += order == 2 ? 1 : 0;
                    part.between += order - 2;
                    part.met += before[walk.index];
                });
        return part;
    }

  private:
    Met met(const FacetWalks::Walk& walk, dvec3 h) const {
        const double cosine = std::min(glm::dot(walk.view, h), 1.0);
        const dvec3 tint =
            shading_.kinds.tint == Tint::varied ? shading_.facet_tint(h, shading_.density(h)) : dvec3{1};
        return {tint, tint * Shading<double>::schlick_weight(cosine), tint * shading_.fresnel(cosine)};
    }

    const Shading<double>& shading_;
    const FacetDistribution& distribution_;
    dvec3 mean_;
};

}  // namespace

double area_everywhere(const Shading<double>& shading, dvec3 mean, dvec3 k) {
    const dvec3 up = k.z < 0 ? -k : k;
    const double g = shading.projected_area(up, shading.table_spot(up));
    return k.z < 0 ? std::max(g - glm::dot(mean, up), 0.0) : g;
}

BounceWalks walk_bounces(const Shading<double>& shading, const FacetDistribution& distribution, int walks,
                         std::uint64_t seed, Workers& workers) {
    const Walker walker(shading, distribution);
    std::vector<Part> parts(1);
    workers.for_each(1, [&](int) { parts[0] = walker(std::min(walks_at_once, walks), seed << 32); });
    const double mean = parts[0].bounces / static_cast<double>(std::min(walks_at_once, walks));
    walks = std::min(walks, std::max(static_cast<int>(bounces_in_all / std::max(mean, 1.0)), walks_at_once));
    const int count = (walks + walks_at_once - 1) / walks_at_once;
    parts.resize(static_cast<std::size_t>(count));
    workers.for_each(count - 1, [&](int i) {
        const int some = std::min(walks_at_once, walks - (i + 1) * walks_at_once);
        parts[static_cast<std::size_t>(i + 1)] =
            walker(some, (seed << 32) + static_cast<std::uint64_t>(i + 1));
    });
    BounceWalks all{.walks = walks};
    Met met;
    int second = 0, between = 0;
    for (const Part& part : parts) {
        all.pairs.insert(all.pairs.end(), part.pairs.begin(), part.pairs.end());
        second += part.second;
        between += part.between;
        met += part.met;
    }
    if (!all.pairs.empty()) all.second = second / static_cast<double>(all.pairs.size());
    if (between > 0) {
        all.tint = met.tint / static_cast<double>(between);
        all.schlick = met.schlick / static_cast<double>(between);
        all.fresnel = met.fresnel / static_cast<double>(between);
    }
    return all;
}

}  // namespace nacre
