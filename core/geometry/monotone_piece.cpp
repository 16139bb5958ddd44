#include "core/geometry/monotone_piece.h"

#include <utility>

namespace nacre {

void MonotonePiece::add(std::size_t corner, Chain chain, std::span<const glm::dvec2> points,
                        std::vector<std::array<std::size_t, 3>>& triangles) {
    // Counterclockwise where a and b follow each other on the low chain.
    auto cut = [&](std::size_t a, std::size_t b, Chain on) {
        if (on == Chain::high) std::swap(a, b);
        triangles.push_back({a, b, corner});
    };
    if (chain != chain_) {
        for (std::size_t i = 0; i + 1 < corners_.size(); ++i) cut(corners_[i], corners_[i + 1], chain_);
        corners_ = {corners_.back(), corner};
        chain_ = chain;
        return;
    }
    while (corners_.size() > 1) {
        const std::size_t a = corners_[corners_.size() - 2], b = corners_.back();
        const double bend = turn(points[a], points[b], points[corner]);
        if (!(chain == Chain::low ? bend > 0 : bend < 0)) break;
        cut(a, b, chain);
        corners_.pop_back();
    }
    corners_.push_back(corner);
}

}  // namespace nacre
