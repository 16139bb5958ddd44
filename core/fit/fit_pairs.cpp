#include "core/fit/fit_pairs.h"

#include <cmath>
#include <numbers>

#include "core/fit/view_mask.h"
#include "core/model/visible_facets.h"

namespace nacre {

namespace {

using std::numbers::pi;

constexpr double even = 0.4;         // the part of facets that are spread evenly
constexpr double cosine_min = 0.01;  // of v and l
constexpr double facing_min = 1e-3;  // of h.v

dvec3 at_cosine(double cosine, Random& random) {
    const double phi = 2 * pi * uniform_random(random);
    const double sine = std::sqrt(std::fmax(1 - cosine * cosine, 0.0));
    return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// False where the pair is left out.
bool complete(const Shading<double>& shading, FitPair& pair) {
    const double facing = glm::dot(pair.h, pair.v);
    pair.l = 2 * facing * pair.h - pair.v;
    if (facing < facing_min || pair.l.z < cosine_min) return false;
    const auto seen_from = [&](dvec3 k) {
        return Shading<double>::known_direction(k, shading.projected_area(k, shading.table_spot(k)),
                                                dvec3{0});
    };
    const auto a = seen_from(pair.v), b = seen_from(pair.l);
    const double p = shading.density(pair.h);
    pair.rho = 0.25 * p * shading.visibility(a, b);
    const double density = (1 - even) * Shading<double>::facet_density(a.g, p) + even / (2 * pi * 4 * facing);
    pair.share = pair.l.z * pi / density;  // v's own density is (n.v)/pi
    return std::isfinite(pair.rho);
}

}  // namespace

std::vector<FitPair> draw_fit_pairs(const Tables& tables, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<FitPair> pairs;
    pairs.reserve(static_cast<std::size_t>(count));
    const VisibleFacets& facets = tables.distribution->visible_facets();
    for (int i = 0; i < count; ++i) {
        FitPair pair{};
        pair.v = at_cosine(std::sqrt(uniform_random(random)), random);
        const bool evenly = uniform_random(random) < even;
        if (pair.v.z < cosine_min) continue;
        if (evenly) {
            pair.h = at_cosine(1 - uniform_random(random), random);
        } else {
            const std::optional<dvec3> h = facets(pair.v, random);
            if (!h || h->z <= 0) continue;
            pair.h = *h;
        }
        if (!complete(tables.shading, pair)) continue;
        pair.visibility = ViewMask::visibility_part(tables, pair.v);
        pairs.push_back(pair);
    }
    return pairs;
}

std::vector<dvec3> draw_fit_facets(const Tables& tables, int count, std::uint64_t seed) {
    Random random(seed);
    const dvec3 n{0, 0, 1};
    std::vector<dvec3> h;
    for (int i = 0; i < count; ++i)
        if (const auto facet = tables.distribution->visible_facets()(n, random); facet && facet->z > 0.02)
            h.push_back(*facet);
    return h;
}

}  // namespace nacre
