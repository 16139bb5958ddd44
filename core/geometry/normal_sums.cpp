#include "core/geometry/normal_sums.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace nacre {
namespace {

constexpr double undivided = 0.25 * std::numbers::pi / 180;  // radius of a node that is in or out as a whole
constexpr std::size_t leaf_normals = 8;

double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

NormalSums::NormalSums(std::vector<WeightedNormal> normals) : normals_(std::move(normals)) {
    if (!normals_.empty()) build(0, 0, normals_.size());
}

void NormalSums::build(std::size_t node, std::size_t begin, std::size_t end) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    glm::dvec3 low = normals_[begin].normal, high = low;
    Node made;
    for (std::size_t i = begin; i < end; ++i) {
        low = glm::min(low, normals_[i].normal);
        high = glm::max(high, normals_[i].normal);
        made.sum += normals_[i].normal * normals_[i].weight;
    }
    const glm::dvec3 middle = low + high;
    const double length = glm::length(middle);
    made.middle = length > 1e-6 ? middle / length : normals_[begin].normal;
    for (std::size_t i = begin; i < end; ++i)
        made.radius = std::max(made.radius, angle_between(made.middle, normals_[i].normal));
    nodes_[node] = made;
    if (end - begin <= leaf_normals || made.radius <= undivided) return;
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return normals_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(half), at(end), [&](const WeightedNormal& a, const WeightedNormal& b) {
        return a.normal[axis] < b.normal[axis];
    });
    build(2 * node + 1, begin, half);
    build(2 * node + 2, half, end);
}

void NormalSums::add(std::size_t node, std::size_t begin, std::size_t end, glm::dvec3 direction, double angle,
                     glm::dvec3& sum, std::size_t& steps) const {
    ++steps;
    const Node& here = nodes_[node];
    const double away = angle_between(here.middle, direction);
    if (away - here.radius > angle) return;
    if (away + here.radius <= angle) {
        sum += here.sum;
    } else if (here.radius <= undivided) {
        if (away <= angle) sum += here.sum;
    } else if (end - begin > leaf_normals) {
        const std::size_t half = begin + (end - begin) / 2;
        add(2 * node + 1, begin, half, direction, angle, sum, steps);
        add(2 * node + 2, half, end, direction, angle, sum, steps);
    } else {
        for (std::size_t i = begin; i < end; ++i, ++steps)
            if (angle_between(normals_[i].normal, direction) <= angle)
                sum += normals_[i].normal * normals_[i].weight;
    }
}

glm::dvec3 NormalSums::within(glm::dvec3 direction, double angle, std::size_t* steps) const {
    glm::dvec3 sum{0};
    std::size_t count = 0;
    if (!normals_.empty()) add(0, 0, normals_.size(), direction, angle, sum, count);
    if (steps != nullptr) *steps += count;
    return sum;
}

}  // namespace nacre
