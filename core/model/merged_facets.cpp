#include "core/model/merged_facets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "core/model/facet_lobe.h"
#include "core/model/moment_pyramid.h"
#include "core/model/pyramid_tile.h"
#include "core/model/visible_sampler.h"

namespace nacre {
namespace {

constexpr int tile_side = tile_side_max;
constexpr std::size_t tile_cells = static_cast<std::size_t>(tile_side) * tile_side;
constexpr int tile_leaves_side = tile_side / 4;
constexpr std::size_t tiles_max = 256;
constexpr std::size_t sketched = 4096;  // facets of each lobe by which the tiles are laid out
constexpr double least_size = 1e-7;     // of a tile

// The sphere on the unit square (Meyer et al. 2010): an octahedron unfolded.
dvec2 octahedral(dvec3 h) {
    const double sum = std::fabs(h.x) + std::fabs(h.y) + std::fabs(h.z);
    dvec2 at{h.x / sum, h.y / sum};
    if (h.z < 0) at = {std::copysign(1 - std::fabs(at.y), at.x), std::copysign(1 - std::fabs(at.x), at.y)};
    return 0.5 * at + 0.5;
}

struct SketchedFacet {
    dvec2 at;
    double mass;
};

// What spreads over the facets of a leaf: the sum of mass (S + 6 u u'), u = h - origin, because a tent of
// half-width a has a variance of a^2/6.
struct LeafSum {
    dvec3 origin{0};  // about one of them: nothing cancels
    Spread sum;
};

// A square of the octahedral map: split in four, or a tile of cells.
struct Square {
    dvec2 corner;
    double size;
    int first_child = -1;
    std::vector<SketchedFacet> facets = {};  // until it is split
    // Row by row, none before the first facet: the moment in each cell, and what lies in each leaf.
    std::vector<dvec3> cells = {};
    std::vector<LeafSum> leaves = {};

    double weight() const {
        double mass = 0;
        for (const SketchedFacet& facet : facets) mass += facet.mass;
        return size > least_size ? mass * size * size : 0;
    }
};

// 0 or 1 along each axis.
int child_of(dvec2 at, const Square& square) {
    const dvec2 middle = square.corner + 0.5 * square.size;
    return (at.x >= middle.x ? 1 : 0) + (at.y >= middle.y ? 2 : 0);
}

// The square with the largest error, by mass times size squared, is split first.
std::vector<Square> lay_out(std::vector<SketchedFacet> facets) {
    std::vector<Square> squares;
    std::priority_queue<std::pair<double, int>> open;
    auto add = [&](Square square) {
        open.emplace(square.weight(), -static_cast<int>(squares.size()));
        squares.push_back(std::move(square));
    };
    add({.corner = {0, 0}, .size = 1, .facets = std::move(facets)});
    for (std::size_t tiles = 1; tiles + 3 <= tiles_max && open.top().first > 0; tiles += 3) {
        const auto index = static_cast<std::size_t>(-open.top().second);
        open.pop();
        std::array<std::vector<SketchedFacet>, 4> parts;
        for (const SketchedFacet& facet : squares[index].facets)
            parts[static_cast<std::size_t>(child_of(facet.at, squares[index]))].push_back(facet);
        squares[index].facets.clear();
        squares[index].first_child = static_cast<int>(squares.size());
        const dvec2 corner = squares[index].corner;
        const double size = 0.5 * squares[index].size;
        for (int i = 0; i < 4; ++i)
            add({.corner = corner + size * dvec2(i % 2, i / 2),
                 .size = size,
                 .facets = std::move(parts[static_cast<std::size_t>(i)])});
    }
    return squares;
}

std::size_t leaf_at(int row, int column) {
    return static_cast<std::size_t>(row / 4 * tile_leaves_side + column / 4);
}

void put(std::vector<Square>& squares, dvec3 moment, const Spread& spread) {
    const double mass = glm::length(moment);
    const dvec3 h = moment / mass;
    const dvec2 at = octahedral(h);
    std::size_t index = 0;
    while (squares[index].first_child >= 0)
        index = static_cast<std::size_t>(squares[index].first_child + child_of(at, squares[index]));
    Square& tile = squares[index];
    tile.cells.resize(tile_cells, dvec3{0});
    tile.leaves.resize(tile_cells / 16);
    const dvec2 place = (at - tile.corner) * (tile_side / tile.size);
    const int row = std::clamp(static_cast<int>(place.y), 0, tile_side - 1);
    const int column = std::clamp(static_cast<int>(place.x), 0, tile_side - 1);
    tile.cells[static_cast<std::size_t>(row * tile_side + column)] += moment;
    LeafSum& leaf = tile.leaves[leaf_at(row, column)];
    if (leaf.origin == dvec3{0}) leaf.origin = h;
    leaf.sum += mass * spread;
    leaf.sum += 6 * mass * spread_along(h - leaf.origin);
}

std::shared_ptr<const PyramidTile> tile_of(const Square& tile) {
    std::vector<Facet> facets(tile_cells, Facet{dvec3{0}, 0});
    std::vector<Spread> spreads(tile_cells / 16);
    for (std::size_t first = 0; first < tile_cells; first += 16) {
        LeafSum leaf = tile.leaves[leaf_at(morton_row(first), morton_column(first))];
        double mass = 0;
        for (std::size_t i = first; i < first + 16; ++i) {
            const dvec3 moment =
                tile.cells[static_cast<std::size_t>(morton_row(i) * tile_side + morton_column(i))];
            const double length = glm::length(moment);
            if (!(length > 0)) continue;
            facets[i] = {moment / length, length};
            leaf.sum += -6 * length * spread_along(facets[i].h - leaf.origin);
            mass += length;
        }
        for (double* square : {&leaf.sum.xx, &leaf.sum.yy, &leaf.sum.zz}) *square = std::max(*square, 0.0);
        if (mass > 0) spreads[first / 16] = (1 / mass) * leaf.sum;
    }
    return std::make_shared<const PyramidTile>(make_tile(facets, spreads));
}

// Every facet of a lobe into the tile where it lies. A patch that the lobe's horizon cuts spreads less.
void put_all(std::vector<Square>& squares, const PlacedLobe& placed) {
    const auto& lobe = dynamic_cast<const FacetLobe&>(*placed.lobe);
    lobe.visit_leaves([&](const LeafBlock& leaf) {
        const Spread spread = rotated(leaf.spread, placed.frame);
        for (std::size_t i = 0; i < 16; ++i) {
            const dvec3 moment = moment_at(leaf, i);
            const double length = glm::length(moment), part = leaf.share[i] / length;
            if (length > 0) put(squares, placed.frame * (placed.scale * moment), part * part * spread);
        }
    });
}

MomentPyramid pyramid_of(const std::vector<PlacedLobe>& lobes) {
    std::vector<SketchedFacet> sketch;
    for (const PlacedLobe& placed : lobes)
        for (const Facet& facet : placed.lobe->facets(sketched))
            sketch.push_back({octahedral(placed.frame * facet.h), placed.scale * facet.mass});
    std::vector<Square> squares = lay_out(std::move(sketch));
    for (const PlacedLobe& placed : lobes) put_all(squares, placed);
    std::erase_if(squares, [](const Square& square) { return square.cells.empty(); });
    std::vector<std::shared_ptr<const PyramidTile>> tiles(squares.size());
    tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) { tiles[i] = tile_of(squares[i]); });
    return MomentPyramid(std::move(tiles));
}

// In the surface's own frame.
class MergedLobe final : public LobeModel {
  public:
    explicit MergedLobe(std::vector<PlacedLobe> lobes)
        : lobes_(std::move(lobes)), pyramid_(pyramid_of(lobes_)) {}

    double density(dvec3 h) const override {
        double sum = 0;
        for (const PlacedLobe& placed : lobes_)
            sum += placed.scale * placed.lobe->density(glm::transpose(placed.frame) * h);
        return sum;
    }
    double mass() const override {
        double sum = 0;
        for (const PlacedLobe& placed : lobes_) sum += placed.scale * placed.lobe->mass();
        return sum;
    }
    Area area(dvec3 k) const override { return pyramid_.area(k); }
    double projected_area(dvec3 k) const override { return pyramid_.projected_area(k); }
    dvec3 mean() const override { return pyramid_.mean(); }
    std::vector<LobeParameterization> spans() const override { return {}; }
    std::vector<LobeParameterization> domains() const override {
        return {LobeParameterization{}, {dvec2{1}, -1, {}}};
    }
    std::vector<Facet> facets(std::size_t count) const override { return pyramid_.facets(count); }
    dvec3 sample_visible(dvec3 k, Random& random) const override { return VisibleSampler(lobes_, k)(random); }

  private:
    std::vector<PlacedLobe> lobes_;
    MomentPyramid pyramid_;
};

}  // namespace

std::size_t count_facets(const Distribution& design) {
    constexpr std::size_t least_side = 256;  // of a set of facets
    std::size_t sum = 0;
    for (const Layer& layer : design.layers) {
        if (!counts(layer) || !holds_picture(layer)) continue;
        std::size_t side = least_side;
        visit_pictures(layer.lobe, [&](const Picture& picture, std::string_view) {
            side = std::max(side, static_cast<std::size_t>(picture.raster->width));
        });
        sum += side * side;
    }
    return sum;
}

std::shared_ptr<const FacetDistribution> merge_facets(const Distribution& design,
                                                      const FacetDistribution& distribution) {
    Distribution layers = design;
    layers.layers.clear();
    std::vector<std::shared_ptr<const LobeModel>> lobes;
    std::vector<PlacedLobe> facets;
    double weight = 0;
    for (const PlacedLobe& placed : distribution.lobes()) {
        const Layer& layer = design.layers[placed.layer];
        if (placed.lobe->spans().empty()) {
            facets.push_back(placed);
            weight += layer.weight;
        } else {
            layers.layers.push_back(layer);
            lobes.push_back(placed.lobe);
        }
    }
    if (!facets.empty()) {
        Layer merged;
        merged.weight = weight;
        layers.layers.push_back(merged);
        lobes.push_back(std::make_shared<const MergedLobe>(std::move(facets)));
    }
    return std::make_shared<const FacetDistribution>(layers,
                                                     [&](const Layer&, std::size_t i) { return lobes[i]; });
}

double merging_error(const FacetDistribution& distribution, const FacetDistribution& merged) {
    constexpr int directions = 64;
    std::array<double, directions> errors{};
    tbb::parallel_for(0, directions, [&](int i) {
        const double c = std::pow((i + 0.5) / directions, 2), s = std::sqrt((1 - c) * (1 + c));
        const double phi = 2 * std::numbers::pi * std::fmod((i + 0.5) * std::numbers::phi, 1.0);
        const dvec3 k{s * std::cos(phi), s * std::sin(phi), c};
        const double exact = distribution.projected_area(k), least = distribution.mean_cosine() * c;
        errors[static_cast<std::size_t>(i)] =
            std::fabs(merged.projected_area(k) - exact) / std::max({exact, least, 1e-300});
    });
    return *std::max_element(errors.begin(), errors.end());
}

}  // namespace nacre
