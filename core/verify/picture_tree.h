// The facets of a lobe that holds a picture, as weights in a quadtree.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/model/disk_quadrature.h"
#include "core/model/facet_distribution.h"

namespace nacre {

// One hemisphere of the lobe, h' seen on the equal-area disk. However rough p is, each box holds the weights
// with which the 4 x 4 points of a Gauss grid give the integral of p times any bicubic: its moments, exact
// for p. Boxes are split to 256 a side, and further where one holds more than a small part of the lobe, so
// that few texels are resolved as well as a whole disk.
class PictureTree {
  public:
    static constexpr std::size_t points = 4, weights = points * points;
    static constexpr int first_level = 5, usual_level = 8, last_level = 20;  // of 2^level boxes a side

    struct Cell {
        std::array<double, weights> weight{};
        std::size_t children = 0;  // the first of four; 0: none

        bool empty() const {
            return std::all_of(weight.begin(), weight.end(), [](double w) { return w == 0; });
        }
    };

    // `span`: one of the lobe's domains. The lobe is kept as a reference.
    PictureTree(const PlacedLobe& placed, const LobeParameterization& span);

    // The boxes of the first level are the first cells.
    static std::size_t first_count() { return std::size_t{1} << (2 * first_level); }
    static Box first_box(std::size_t cell);
    static Box child_box(const Box& box, std::size_t child);
    const Cell& cell(std::size_t index) const { return cells_[index]; }

    // h at a point of a box, in the surface's frame.
    dvec3 direction(const Box& box, std::size_t point) const;

  private:
    // A place on the disk, and the facets that stand there.
    struct Point {
        dvec2 at;
        double mass;
    };
    struct Bins;

    void grow(std::size_t cell, const Box& box, int level, const Bins& bins);
    void part(std::size_t cell, const Box& box, int level, const std::vector<Point>& inside);
    void fill(Cell& cell, const Box& box) const;
    void add_up(std::size_t cell);
    std::size_t add_children(std::size_t cell);
    template <class Visit>
    void visit_points(const Visit& visit) const;

    const PlacedLobe& placed_;
    LobeParameterization span_;
    std::vector<int> sides_;  // of the pictures whose lines run along the disk's axes
    double heavy_;            // what a box holds that is split further
    std::vector<Cell> cells_;
};

}  // namespace nacre
