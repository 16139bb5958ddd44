// Means over random walks between facets, and how sure they are.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/bake/workers.h"
#include "core/model/facet_walks.h"

namespace nacre {

// A mean over walks and the standard error of it, each colour.
struct WalkEstimate {
    dvec3 mean{0};
    dvec3 error{0};
};

struct WalkEffort {
    int walks = 65536;
    std::uint64_t seed = 1;
    int first = 2, last = 1 << 20;  // bounces that count; the first is that of the walks' own masking
};

// Sums of what each walk scores, and of the squares.
struct WalkScores {
    dvec3 sum{0}, squares{0};

    void add(dvec3 score) {
        sum += score;
        squares += score * score;
    }
};

WalkEstimate estimate(const std::vector<WalkScores>& parts, int walks);

// (1 - part) a + part b.
WalkEstimate mixed(double part, const WalkEstimate& a, const WalkEstimate& b);

// Of a walk that goes on after so many bounces, whether it does: light that is all but absorbed, and that
// which stays for long, goes on with a chance and the greater weight.
void survive(FacetWalks::Walk& walk, int order, Random& random);

// Walks of light from k1, some at a time: visit(where each begins, random, scores) lets them go and adds what
// each scores at its index. Throws BakeCancelled.
template <class Visit>
WalkEstimate over_walks(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop, const Visit& visit) {
    constexpr int walks_at_once = 1024;
    const int count = (effort.walks + walks_at_once - 1) / walks_at_once;
    std::vector<WalkScores> parts(static_cast<std::size_t>(count));
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

}  // namespace nacre
