// A part of a polygon that a sweep cuts into triangles while its corners come from left to right.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/corner_tree.h"

namespace nacre {

// Which of a part's two chains a corner is on.
enum class Chain { low, high };

inline Chain other(Chain chain) { return chain == Chain::low ? Chain::high : Chain::low; }

// What is not yet cut of a part that every vertical meets in one interval: corners that bend inward on one
// chain, after the newest one of the other.
class MonotonePiece {
  public:
    MonotonePiece() = default;
    explicit MonotonePiece(std::size_t first) : corners_{first} {}

    std::size_t newest() const { return corners_.back(); }
    Chain chain() const { return chain_; }  // of the newest

    // The next corner to the right.
    void add(std::size_t corner, Chain chain, std::span<const glm::dvec2> points,
             std::vector<std::array<std::size_t, 3>>& triangles);

    // The last one, in which both chains end.
    void close(std::size_t corner, std::span<const glm::dvec2> points,
               std::vector<std::array<std::size_t, 3>>& triangles) {
        add(corner, other(chain_), points, triangles);
    }

  private:
    std::vector<std::size_t> corners_;
    Chain chain_ = Chain::low;
};

}  // namespace nacre
