#include "core/model/pyramid_tile.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

// The ball round its children's balls, about the mean of their centres.
PyramidCell parent_of(const PyramidCell* children) {
    PyramidCell parent;
    double kept = 0;
    for (int c = 0; c < 4; ++c) {
        if (children[c].radius < 0) continue;
        parent.moment += children[c].moment;
        parent.centre += children[c].centre;
        kept += 1;
    }
    if (kept == 0) return parent;
    parent.centre /= kept;
    for (int c = 0; c < 4; ++c)
        if (children[c].radius >= 0)
            parent.radius =
                std::max(parent.radius, glm::length(children[c].centre - parent.centre) + children[c].radius);
    return parent;
}

// Every second bit of a Morton index below 2^32.
int every_second_bit(std::size_t index) {
    std::size_t x = index & 0x55555555;
    x = (x | (x >> 1)) & 0x33333333;
    x = (x | (x >> 2)) & 0x0F0F0F0F;
    x = (x | (x >> 4)) & 0x00FF00FF;
    return static_cast<int>((x | (x >> 8)) & 0x0000FFFF);
}

// The cell of 16 facets, their moments put into `leaf`.
PyramidCell leaf_cell(const Facet* facets, LeafBlock& leaf, double& mass) {
    PyramidCell cell;
    const double depth = std::max(std::sqrt(leaf.spread.zz), 1e-300);
    double kept = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        const dvec3 moment = facets[i].mass * facets[i].h;
        leaf.x[i] = moment.x;
        leaf.y[i] = moment.y;
        leaf.z[i] = moment.z;
        leaf.share[i] = facets[i].mass * std::min(1.0, std::fabs(facets[i].h.z) / depth);
        if (facets[i].mass <= 0) continue;
        mass += facets[i].mass;
        cell.moment += moment;
        cell.centre += facets[i].h;
        kept += 1;
    }
    if (kept == 0) return cell;
    cell.centre /= kept;
    double square = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        const dvec3 away = facets[i].h - cell.centre;
        if (facets[i].mass > 0) square = std::max(square, glm::dot(away, away));
    }
    cell.radius = std::sqrt(square) + leaf.spread.half_width();
    return cell;
}

}  // namespace

int morton_row(std::size_t index) { return every_second_bit(index >> 1); }
int morton_column(std::size_t index) { return every_second_bit(index); }

void put_cell(const PyramidCell& cell, std::size_t place, MomentBlock& moments, BallBlock& balls) {
    moments.x[place] = cell.moment.x;
    moments.y[place] = cell.moment.y;
    moments.z[place] = cell.moment.z;
    balls.x[place] = static_cast<float>(cell.centre.x);
    balls.y[place] = static_cast<float>(cell.centre.y);
    balls.z[place] = static_cast<float>(cell.centre.z);
    balls.radius[place] = cell.radius < 0 ? -1.0F : static_cast<float>(cell.radius * (1 + 1e-6) + 1e-6);
}

double visible_area(const LeafBlock& leaf, std::size_t facet, dvec3 k) {
    const Spread& s = leaf.spread;
    const double seen = glm::dot(k, moment_at(leaf, facet));
    const double square = s.xx * k.x * k.x + s.yy * k.y * k.y + s.zz * k.z * k.z +
                          2 * (s.xy * k.x * k.y + s.xz * k.x * k.z + s.yz * k.y * k.z);
    const double a = leaf.share[facet] * std::sqrt(std::max(square, 0.0)), rest = a - std::fabs(seen);
    return std::max(seen, 0.0) + (rest > 0 ? rest * (rest / a) * (rest / a) / 6 : 0);
}

PyramidTile make_tile(const std::vector<Facet>& facets, const std::vector<Spread>& spreads) {
    PyramidTile tile;
    tile.leaves.resize(facets.size() / 16);
    std::vector<PyramidCell> cells(tile.leaves.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        tile.leaves[i].spread = spreads[i];
        cells[i] = leaf_cell(&facets[16 * i], tile.leaves[i], tile.mass);
    }
    tile.balls.resize((cells.size() - 1) / 3);
    tile.moments.resize(tile.balls.size());
    for (std::size_t blocks = cells.size() / 4; blocks > 0; blocks /= 4) {
        const std::size_t first = (blocks - 1) / 3;
        for (std::size_t i = 0; i < blocks; ++i) {
            const PyramidCell* children = &cells[4 * i];
            for (std::size_t c = 0; c < 4; ++c)
                put_cell(children[c], c, tile.moments[first + i], tile.balls[first + i]);
            cells[i] = parent_of(children);
        }
    }
    tile.root = cells.front();
    return tile;
}

}  // namespace nacre
