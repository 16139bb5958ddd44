#include "core/model/moment_pyramid.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

// Every second bit of a Morton index: the column; of index / 2: the row.
std::uint32_t every_second_bit(std::uint64_t index) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < 16; ++bit) result |= static_cast<std::uint32_t>((index >> (2 * bit)) & 1) << bit;
    return result;
}

}  // namespace

MomentPyramid::MomentPyramid(int side, const std::vector<Facet>& facets) : side_(side) {
    const std::size_t leaves = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    first_leaf_ = (leaves - 1) / 3;
    nodes_.resize(first_leaf_ + leaves);
    for (std::size_t i = 0; i < leaves; ++i) {
        const std::size_t row = every_second_bit(i >> 1), column = every_second_bit(i);
        const Facet& facet = facets[row * static_cast<std::size_t>(side) + column];
        if (facet.mass <= 0) continue;
        nodes_[first_leaf_ + i] = {facet.mass * facet.h, facet.h, 0};
        mass_ += facet.mass;
    }
    for (std::size_t i = first_leaf_; i-- > 0;) {
        Node& node = nodes_[i];
        double kept = 0;
        for (std::size_t c = 4 * i + 1; c <= 4 * i + 4; ++c) {
            if (nodes_[c].radius < 0) continue;
            node.moment += nodes_[c].moment;
            node.centre += nodes_[c].centre;
            kept += 1;
        }
        if (kept == 0) continue;
        node.centre /= kept;
        for (std::size_t c = 4 * i + 1; c <= 4 * i + 4; ++c) {
            if (nodes_[c].radius < 0) continue;
            node.radius =
                std::max(node.radius, glm::length(nodes_[c].centre - node.centre) + nodes_[c].radius);
        }
    }
}

void MomentPyramid::add(std::size_t index, dvec3 k, Area& sum) const {
    const Node& node = nodes_[index];
    if (node.radius < 0) return;
    const double distance = glm::dot(k, node.centre);
    if (distance <= -node.radius) return;
    if (distance >= node.radius || is_leaf(index)) {
        sum.g += glm::dot(k, node.moment);
        sum.gradient += node.moment;
        return;
    }
    for (std::size_t c = 4 * index + 1; c <= 4 * index + 4; ++c) add(c, k, sum);
}

Area MomentPyramid::area(dvec3 k) const {
    Area sum;
    add(0, k, sum);
    sum.g = std::max(sum.g, 0.0);
    return sum;
}

std::vector<Facet> MomentPyramid::facets(std::size_t count) const {
    std::size_t begin = first_leaf_, end = nodes_.size();
    while (count > 0 && end - begin > count && begin > 0) {
        end = begin;
        begin = (begin - 1) / 4;
    }
    std::vector<Facet> result;
    for (std::size_t i = begin; i < end; ++i) {
        const double length = glm::length(nodes_[i].moment);
        if (nodes_[i].radius >= 0 && length > 0) result.push_back({nodes_[i].moment / length, length});
    }
    return result;
}

std::size_t MomentPyramid::sample_visible(dvec3 k, Random& random) const {
    std::size_t index = 0;
    while (!is_leaf(index)) {
        double part[4];
        double total = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            Area sum;
            add(4 * index + 1 + c, k, sum);
            total += part[c] = std::max(sum.g, 0.0);
        }
        double left = uniform_random(random) * total;
        std::size_t chosen = 3;
        for (std::size_t c = 0; c < 4; ++c) {
            if (part[c] > 0) chosen = c;
            if (left < part[c]) break;
            left -= part[c];
        }
        index = 4 * index + 1 + chosen;
    }
    const std::size_t leaf = index - first_leaf_;
    return every_second_bit(leaf >> 1) * static_cast<std::size_t>(side_) + every_second_bit(leaf);
}

}  // namespace nacre
