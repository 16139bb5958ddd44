#include "core/model/moment_pyramid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "core/model/pyramid_tile.h"

namespace nacre {
namespace {

// A cell waiting to be split: a node of a tile, or a facet of one of its leaves.
struct OpenCell {
    double error;  // mass times the square of the ball's radius
    std::size_t tile;
    std::size_t node;
    dvec3 moment;

    bool operator<(const OpenCell& other) const {
        if (error != other.error) return error < other.error;
        return tile != other.tile ? tile > other.tile : node > other.node;
    }
};

std::size_t draw(const std::vector<double>& part, Random& random) {
    double total = 0;
    for (const double p : part) total += p;
    double left = uniform_random(random) * total;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (part[i] > 0) chosen = i;
        if (left < part[i]) break;
        left -= part[i];
    }
    return chosen;
}

std::shared_ptr<const PyramidTile> tile_of(int row, int column, int side,
                                           const MomentPyramid::FacetAt& facet_at,
                                           const MomentPyramid::SpreadAt& spread_at) {
    std::vector<Facet> facets(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (std::size_t i = 0; i < facets.size(); ++i)
        facets[i] = facet_at(row + morton_row(i), column + morton_column(i));
    std::vector<Spread> spreads(facets.size() / 16);
    for (std::size_t i = 0; i < spreads.size() && spread_at; ++i)
        spreads[i] = spread_at(row + 4 * morton_row(i) + 2, column + 4 * morton_column(i) + 2);
    return std::make_shared<const PyramidTile>(make_tile(facets, spreads));
}

}  // namespace

MomentPyramid::MomentPyramid(int side, const FacetAt& facet_at, const SpreadAt& spread_at)
    : side_(side), tile_side_(std::min(side, tile_side_max)), tiles_(side / tile_side_) {
    top_.tiles.resize(static_cast<std::size_t>(tiles_) * static_cast<std::size_t>(tiles_));
    tbb::parallel_for(0, tiles_ * tiles_, [&](int i) {
        top_.tiles[static_cast<std::size_t>(i)] =
            tile_of(i / tiles_ * tile_side_, i % tiles_ * tile_side_, tile_side_, facet_at, spread_at);
    });
    add_up();
}

MomentPyramid::MomentPyramid(std::vector<std::shared_ptr<const PyramidTile>> tiles)
    : side_(tile_side_max), tile_side_(tile_side_max), tiles_(1) {
    top_.tiles = std::move(tiles);
    add_up();
}

MomentPyramid MomentPyramid::changed(const Part& part, const FacetAt& facet_at,
                                     const SpreadAt& spread_at) const {
    MomentPyramid result = *this;
    for (int row = part.row_begin / tile_side_; row * tile_side_ < part.row_end; ++row)
        for (int column = part.column_begin / tile_side_; column * tile_side_ < part.column_end; ++column)
            result.top_.tiles[static_cast<std::size_t>(row * tiles_ + column)] =
                tile_of(row * tile_side_, column * tile_side_, tile_side_, facet_at, spread_at);
    result.add_up();
    return result;
}

void MomentPyramid::add_up() {
    const std::size_t blocks = (top_.tiles.size() + 3) / 4;
    top_.moments.assign(blocks, {});
    top_.balls.assign(blocks, {});
    mass_ = 0;
    mean_ = dvec3{0};
    for (std::size_t i = 0; i < 4 * blocks; ++i) {
        const PyramidCell cell = i < top_.tiles.size() ? top_.tiles[i]->root : PyramidCell{};
        put_cell(cell, i % 4, top_.moments[i / 4], top_.balls[i / 4]);
        if (i >= top_.tiles.size()) continue;
        mass_ += top_.tiles[i]->mass;
        mean_ += cell.moment;
    }
}

void MomentPyramid::visit_leaves(const std::function<void(const LeafBlock&)>& visit) const {
    for (const auto& tile : top_.tiles)
        for (const LeafBlock& leaf : tile->leaves) visit(leaf);
}

std::vector<Facet> MomentPyramid::facets(std::size_t count) const {
    std::vector<Facet> result;
    auto add = [&](dvec3 moment) {
        const double length = glm::length(moment);
        if (length > 0) result.push_back({moment / length, length});
    };
    if (count == 0) {
        visit_leaves([&](const LeafBlock& leaf) {
            for (std::size_t i = 0; i < 16; ++i) add(moment_at(leaf, i));
        });
        return result;
    }
    std::priority_queue<OpenCell> open;
    auto wait = [&](dvec3 moment, double radius, std::size_t tile, std::size_t node) {
        const double mass = glm::length(moment);
        if (mass > 0) open.push({mass * radius * radius, tile, node, moment});
    };
    for (std::size_t i = 0; i < top_.tiles.size(); ++i)
        wait(top_.tiles[i]->root.moment, top_.tiles[i]->root.radius, i, 0);
    while (!open.empty() && open.top().error > 0) {
        const OpenCell cell = open.top();
        const PyramidTile& tile = *top_.tiles[cell.tile];
        const bool leaf = cell.node >= tile.balls.size();
        if (open.size() + (leaf ? 15 : 3) > count) break;
        open.pop();
        for (std::size_t c = 0; c < (leaf ? 16 : 4); ++c) {
            if (leaf) {
                wait(moment_at(tile.leaves[cell.node - tile.balls.size()], c), 0, cell.tile,
                     16 * cell.node + c);
            } else {
                wait(moment_at(tile.moments[cell.node], c),
                     static_cast<double>(tile.balls[cell.node].radius[c]), cell.tile, 4 * cell.node + 1 + c);
            }
        }
    }
    for (; !open.empty(); open.pop()) add(open.top().moment);
    return result;
}

std::size_t MomentPyramid::sample_visible(dvec3 k, Random& random) const {
    std::vector<double> parts;
    for (const auto& tile : top_.tiles)
        parts.push_back(tile->root.radius < 0 || glm::dot(k, tile->root.centre) <= -tile->root.radius
                            ? 0
                            : sum_visible_area(*tile, 0, k));
    const std::size_t chosen = draw(parts, random);
    const PyramidTile& tile = *top_.tiles[chosen];
    const std::size_t inner = tile.balls.size();
    std::size_t node = 0, index = 0;
    while (node < inner) {
        parts.resize(4);
        for (std::size_t c = 0; c < 4; ++c) parts[c] = sum_visible_area(tile, 4 * node + 1 + c, k);
        const std::size_t child = draw(parts, random);
        index = 4 * index + child;
        node = 4 * node + 1 + child;
    }
    parts.resize(16);
    for (std::size_t i = 0; i < 16; ++i) parts[i] = visible_area(tile.leaves[node - inner], i, k);
    index = 16 * index + draw(parts, random);
    const int row = static_cast<int>(chosen) / tiles_ * tile_side_ + morton_row(index);
    const int column = static_cast<int>(chosen) % tiles_ * tile_side_ + morton_column(index);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column);
}

}  // namespace nacre
