#include "core/light/direction_order.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace nacre {
namespace {

// Place number i of a cell: the sequence R2 (Roberts 2018), turned by a constant.
glm::dvec2 scattered(std::size_t i) {
    const double n = static_cast<double>(i);
    return {std::fmod(0.5 + n * 0.7548776662466927, 1.0), std::fmod(0.5 + n * 0.5698402909980532, 1.0)};
}

// The mean of a range and the root mean square distance from it. Distances are taken from one of the
// directions, so that the spread of a needle keeps its digits.
glm::vec4 node_of(const glm::vec4* first, std::size_t count) {
    const glm::dvec3 origin(first[0]);
    glm::dvec3 sum{0};
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 offset = glm::dvec3(first[i]) - origin;
        sum += offset;
        squares += glm::dot(offset, offset);
    }
    const glm::dvec3 mean = sum / static_cast<double>(count);
    const double spread =
        std::sqrt(std::max(squares / static_cast<double>(count) - glm::dot(mean, mean), 0.0));
    return {glm::vec3(origin + mean), static_cast<float>(spread)};
}

}  // namespace

DirectionOrder order_directions(const MassCells& cells) {
    std::vector<double> rising(cells.mass.size());
    std::partial_sum(cells.mass.begin(), cells.mass.end(), rising.begin());
    const double step = rising.back() / order_count;

    DirectionOrder order;
    order.texels.resize(order_nodes + order_count);
    glm::vec4* directions = order.texels.data() + order_nodes;
    tbb::parallel_for(0, order_leaves, [&](int leaf) {
        for (int i = leaf * order_leaf_size; i < (leaf + 1) * order_leaf_size; ++i) {
            const auto at = std::upper_bound(rising.begin(), rising.end(), (i + 0.5) * step);
            const std::size_t cell =
                std::min(static_cast<std::size_t>(at - rising.begin()), rising.size() - 1);
            directions[i] =
                glm::vec4(glm::vec3(cells.direction(cell, scattered(static_cast<std::size_t>(i)))), 0);
        }
    });
    int node = 0;
    for (int level = 1; level <= order_levels; ++level) {
        const int ranges = 1 << (2 * level);
        tbb::parallel_for(0, ranges, [&](int i) {
            order.texels[static_cast<std::size_t>(node + i)] =
                node_of(directions + static_cast<std::ptrdiff_t>(i) * (order_count / ranges),
                        static_cast<std::size_t>(order_count / ranges));
        });
        node += ranges;
    }
    return order;
}

}  // namespace nacre
