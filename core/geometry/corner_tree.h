// Finds the corners of a polygon that block the cutting of an ear, by position.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace nacre {

// Twice the area of the triangle, negative where it turns clockwise.
inline double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A k-d tree (Bentley 1975) of points that can be switched off and on.
class CornerTree {
  public:
    // All are off at first. The points must outlive the tree.
    explicit CornerTree(std::span<const glm::dvec2> points);

    void set(std::size_t point, bool on);

    // Whether blocks(point) holds for one that is on and lies inside the triangle, or on its edge where that
    // counts too. The triangle turns counterclockwise.
    template <class Blocks>
    bool any_in(const std::array<glm::dvec2, 3>& triangle, bool edge_counts, const Blocks& blocks) {
        return any_in(0, 0, order_.size(), triangle, edge_counts, blocks);
    }

    std::size_t steps() const { return steps_; }  // nodes and points that any_in() has looked at

  private:
    struct Node {
        glm::dvec2 low{0}, high{0};
        std::size_t on = 0;
    };

    static constexpr std::size_t leaf_points = 8;

    void build(std::size_t node, std::size_t begin, std::size_t end);
    static bool apart(const Node& node, const std::array<glm::dvec2, 3>& triangle, bool edge_counts);
    static bool outside(double turn, bool edge_counts) { return edge_counts ? turn < 0 : turn <= 0; }

    template <class Blocks>
    bool any_in(std::size_t node, std::size_t begin, std::size_t end,
                const std::array<glm::dvec2, 3>& triangle, bool edge_counts, const Blocks& blocks) {
        ++steps_;
        if (nodes_[node].on == 0 || apart(nodes_[node], triangle, edge_counts)) return false;
        if (end - begin > leaf_points) {
            const std::size_t middle = begin + (end - begin) / 2;
            return any_in(2 * node + 1, begin, middle, triangle, edge_counts, blocks) ||
                   any_in(2 * node + 2, middle, end, triangle, edge_counts, blocks);
        }
        const auto& [a, b, c] = triangle;
        for (std::size_t i = begin; i < end; ++i) {
            ++steps_;
            if (!on_[order_[i]]) continue;
            const glm::dvec2 p = points_[order_[i]];
            if (outside(turn(a, b, p), edge_counts) || outside(turn(b, c, p), edge_counts) ||
                outside(turn(c, a, p), edge_counts))
                continue;
            if (blocks(order_[i])) return true;
        }
        return false;
    }

    std::span<const glm::dvec2> points_;
    std::vector<std::size_t> order_, place_;  // points by place in the tree, and the other way round
    std::vector<Node> nodes_;                 // the children of i are 2 i + 1 and 2 i + 2
    std::vector<bool> on_;
    std::size_t steps_ = 0;
};

}  // namespace nacre
