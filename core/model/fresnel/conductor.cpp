#include "core/model/fresnel/conductor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/model/fresnel/f82.h"
#include "core/model/shading.h"

namespace nacre {
namespace {

// Of one colour.
struct Index {
    double eta, k;
};

// eta from its lowest with this reflectance, at tint 1, to its highest, where k is 0    (Gulbrandsen 2014)
Index tinted_index(double r, double tint) {
    const double root = std::sqrt(r);
    const double eta = tint * (1 - r) / (1 + r) + (1 - tint) * (1 + root) / (1 - root);
    const double k2 = (r * (eta + 1) * (eta + 1) - (eta - 1) * (eta - 1)) / (1 - r);
    return {eta, std::sqrt(std::max(k2, 0.0))};
}

bool within_limits(const Index& index) {
    return index.eta >= limits::eta_min && index.eta <= limits::eta_max && index.k <= limits::k_max;
}

struct Candidate {
    Index index;
    double off;  // at 82 degrees
};

// Of those that are about as near as the nearest, the one with the smallest eta: a reflectance near 1 has
// them up to eta = k = 100, where no metal is.
Index index_of(double normal, double edge) {
    constexpr int tints = 2000;
    constexpr double as_near = 0.01;
    const double r = std::clamp(normal, 0.001, 0.998);
    std::vector<Candidate> candidates;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= tints; ++i) {
        const Index index = tinted_index(r, static_cast<double>(i) / tints);
        if (!within_limits(index)) continue;
        const double f = Shading<double>::conductor_reflectance(index.eta, index.k, F82Fresnel::cosine82);
        candidates.push_back({index, std::fabs(f - edge)});
        least = std::min(least, candidates.back().off);
    }
    std::erase_if(candidates, [&](const Candidate& c) { return c.off > least + as_near; });
    return std::ranges::min_element(candidates, {}, [](const Candidate& c) { return c.index.eta; })->index;
}

}  // namespace

ConductorFresnel ConductorFresnel::of_reflectance(const Reflectance& wanted) {
    const glm::dvec3 normal = wanted(1), edge = wanted(F82Fresnel::cosine82);
    ConductorFresnel conductor;
    for (int i = 0; i < 3; ++i) {
        const Index index = index_of(normal[i], edge[i]);
        conductor.eta[i] = index.eta;
        conductor.k[i] = index.k;
    }
    return conductor;
}

}  // namespace nacre
