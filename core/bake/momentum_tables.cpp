#include "core/bake/momentum_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bounce_directions.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;

constexpr int directions_summed = 4096;
constexpr std::size_t pairs_compared = 262144;

// Cells of a hemisphere that are equally large seen from above.
constexpr int cell_rings = 6, cell_sectors = 16, cells = cell_rings * cell_sectors;

int cell_of(dvec3 k) {
    const double r2 = k.x * k.x + k.y * k.y, turn = std::atan2(k.y, k.x) / (2 * pi) + 1;
    const int ring = std::min(static_cast<int>(r2 * cell_rings), cell_rings - 1);
    return ring * cell_sectors + static_cast<int>(turn * cell_sectors) % cell_sectors;
}

// Both directions by p's mirror planes or its roundness, so that k1 is where few cells are.
BouncePair folded(const Shader& shading, BouncePair pair) {
    const auto& shape = shading.surface.tables;
    const dvec2 axis = shape.symmetry == Shader::SYMMETRY_ISOTROPIC
                           ? (glm::length(dvec2(pair.k1)) > 0 ? glm::normalize(dvec2(pair.k1)) : dvec2{1, 0})
                           : dvec2(shape.axis);
    for (dvec3* k : {&pair.k1, &pair.k2})
        *k = {axis.x * k->x + axis.y * k->y, axis.x * k->y - axis.y * k->x, k->z};
    if (shape.symmetry == Shader::SYMMETRY_NONE) return pair;
    const bool round = shape.symmetry == Shader::SYMMETRY_ISOTROPIC;
    if (round ? pair.k2.y < 0 : pair.k1.y < 0) {
        pair.k1.y = -pair.k1.y;
        pair.k2.y = -pair.k2.y;
    }
    if (shape.symmetry == Shader::SYMMETRY_QUARTER && pair.k1.x < 0) {
        pair.k1.x = -pair.k1.x;
        pair.k2.x = -pair.k2.x;
    }
    return pair;
}

}  // namespace

int albedo_node_count(const Shading<double>& shading) {
    return shading.surface.tables.nodes_v * shading.surface.tables.nodes_rho;
}

dvec3 albedo_node(const Shading<double>& shading, const StretchedGrid& grid, int i) {
    const auto& shape = shading.surface.tables;
    return grid.albedo_direction(i % shape.nodes_v / (shape.nodes_v - 1.0), i / shape.nodes_v,
                                 shape.nodes_rho);
}

// The shader says it of the last of all points: the first of its four neighbours, and the one in the next
// row.
glm::ivec2 momentum_size(const Shading<double>& shading, bool difference) {
    const dvec2 axis = shading.surface.tables.axis;
    glm::ivec2 size{0};
    for (const dvec2 t : {dvec2{2, 2}, dvec2{-2, 2}, dvec2{2, -2}, dvec2{-2, -2}}) {
        const dvec2 turned{axis.x * t.x - axis.y * t.y, axis.y * t.x + axis.x * t.y};
        const auto spot = shading.momentum_spot(turned, difference);
        const int columns = spot.second == spot.first ? spot.first + 2 : spot.second - spot.first;
        size = glm::max(size, {columns, (spot.second + 2) / columns});
    }
    return size;
}

double misplaced_energy(const Shading<double>& shading, const BounceWalks& walks) {
    std::vector<double> seen(static_cast<std::size_t>(cells * cells)), expected = seen;
    const auto slot = [&](const BouncePair& pair) {
        const BouncePair in = folded(shading, pair);
        return static_cast<std::size_t>(cell_of(in.k1) * cells + cell_of(in.k2));
    };
    for (const BouncePair& pair : walks.pairs) seen[slot(pair)] += 1.0 / walks.walks;
    Shader white = shading;
    white.surface.bounce_scale = dvec3{1};
    const std::vector<BouncePair> anywhere = even_pairs(pairs_compared);
    for (const BouncePair& pair : anywhere) {
        auto a = white.direction(pair.k1), b = white.direction(pair.k2);
        a.bounce_F = b.bounce_F = dvec3{1};
        expected[slot(pair)] += white.multibounce(a, b).x * pi / static_cast<double>(anywhere.size());
    }
    double misplaced = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double noise = std::sqrt(2 / pi * expected[i] / walks.walks);
        misplaced += std::max(std::fabs(seen[i] - expected[i]) - noise, 0.0);
    }
    return misplaced;
}

std::vector<dvec3> momentum_rows(const Shading<double>& shading, const StretchedGrid& grid,
                                 const std::function<dvec3(dvec3)>& factor, Workers& workers) {
    constexpr int count = directions_summed;
    const std::vector<dvec3> directions = even_directions(count);
    std::vector<Shader::Direction> ends;
    std::vector<dvec3> factors;
    for (const dvec3 k : directions) {
        ends.push_back(Shader::known_direction(k, 0, dvec3{0}));
        ends.back().amplitude = shading.momentum_amplitude(k);
        factors.push_back(factor(k) * (pi / count));
    }
    std::vector<dvec3> rows(static_cast<std::size_t>(albedo_node_count(shading)));
    workers.for_each(static_cast<int>(rows.size()), [&](int i) {
        const dvec3 k = albedo_node(shading, grid, i);
        auto a = Shader::known_direction(k, 0, dvec3{0});
        a.amplitude = 1;
        dvec3 sum{0};
        for (std::size_t j = 0; j < ends.size(); ++j) sum += shading.momentum_kernel(a, ends[j]) * factors[j];
        rows[static_cast<std::size_t>(i)] = sum;
    });
    return rows;
}

void smooth_table(std::vector<double>& texels, int first, glm::ivec2 size, double part) {
    const std::vector<double> before = texels;
    const auto index = [&](int column, int row) {
        const int x = std::clamp(column, 0, size.x - 1), y = std::clamp(row, 0, size.y - 1);
        return static_cast<std::size_t>(first + y * size.x + x);
    };
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column) {
            double& texel = texels[index(column, row)];
            for (const glm::ivec2 off : {glm::ivec2{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
                texel += part * (before[index(column + off.x, row + off.y)] - before[index(column, row)]);
        }
}

}  // namespace nacre
