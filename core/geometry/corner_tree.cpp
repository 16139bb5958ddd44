#include "core/geometry/corner_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

namespace nacre {

CornerTree::CornerTree(std::span<const glm::dvec2> points)
    : points_(points), order_(points.size()), place_(points.size()), on_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    build(0, 0, order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) place_[order_[i]] = i;
}

void CornerTree::build(std::size_t node, std::size_t begin, std::size_t end) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    Node box;
    box.low = box.high = points_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) {
        box.low = glm::min(box.low, points_[order_[i]]);
        box.high = glm::max(box.high, points_[order_[i]]);
    }
    nodes_[node] = box;
    if (end - begin <= leaf_points) return;
    const int axis = box.high.x - box.low.x >= box.high.y - box.low.y ? 0 : 1;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t place) { return order_.begin() + static_cast<std::ptrdiff_t>(place); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](std::size_t a, std::size_t b) { return points_[a][axis] < points_[b][axis]; });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
}

void CornerTree::set(std::size_t point, bool on) {
    if (on_[point] == on) return;
    on_[point] = on;
    std::size_t node = 0, begin = 0, end = order_.size();
    while (true) {
        if (on)
            ++nodes_[node].on;
        else
            --nodes_[node].on;
        if (end - begin <= leaf_points) return;
        const std::size_t middle = begin + (end - begin) / 2;
        const bool first = place_[point] < middle;
        node = 2 * node + (first ? 1 : 2);
        (first ? end : begin) = middle;
    }
}

// The box lies beyond one of the triangle's edges, or beside its own box.
bool CornerTree::apart(const Node& node, const std::array<glm::dvec2, 3>& triangle, bool edge_counts) {
    const auto& [a, b, c] = triangle;
    const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    if (node.low.x > high.x || node.low.y > high.y || node.high.x < low.x || node.high.y < low.y) return true;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 from = triangle[i], along = triangle[(i + 1) % 3] - from;
        // The box's corner that lies farthest to the left of the edge.
        const glm::dvec2 corner(along.y > 0 ? node.low.x : node.high.x,
                                along.x > 0 ? node.high.y : node.low.y);
        if (outside(turn(from, triangle[(i + 1) % 3], corner), edge_counts)) return true;
    }
    return false;
}

}  // namespace nacre
