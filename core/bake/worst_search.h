// Searches for the largest error of a table: in the cells where its nodes curve most, then uphill from the
// worst.
#pragma once

#include <functional>
#include <vector>

#include "core/bake/table_points.h"
#include "core/bake/tables.h"

namespace nacre {

// The smallest k.n of a search and of the checks of claims: closer to the horizon arbitrarily thin
// layers could be found.
inline constexpr double lowest_cosine = 1e-5;

// k, or the direction above it at that height.
dvec3 not_below_lowest(dvec3 k);

// For each cell the most that a table of these nodes, row by row, bends at a corner: of what is smooth,
// linear interpolation has an error of an eighth of its second differences. `weights`: what an error at each
// node counts.
std::vector<double> cell_bends(TableNodes nodes, Symmetry symmetry, const float* values,
                               const std::vector<double>& weights);

// How many cells and climbs: thorough where the error is more than was wanted, so that what is claimed is
// known better.
enum class Search { usual, thorough };

// The errors of one table at chosen points, and the worst of them.
class WorstSearch {
  public:
    // The errors at these points, several at a time.
    using ErrorsAt = std::function<std::vector<double>(const std::vector<TablePoint>&)>;

    WorstSearch(const TableCells& cells, ErrorsAt errors_at)
        : cells_(cells), errors_at_(std::move(errors_at)) {}

    void look_at(const std::vector<TablePoint>& points);

    // In the cells that curve most. `between`: errors between nodes are not known yet.
    void look_at_bends(const std::vector<double>& bends, int count, bool between);

    // From the worst points, no two of them neighbours, to where the error is largest.
    void climb(int starts);

    // Errors that are known already.
    void know(const std::vector<TablePoint>& points, const std::vector<double>& errors);

    double worst() const;

    // Raises the worst errors to what was found.
    void add_to(AxisError& error) const;

  private:
    struct Climb {
        TablePoint point;
        double error;
        double step;  // cells
    };

    TablePoint moved(const TablePoint& from, double across, double down) const;
    std::vector<Climb> choose_starts(int count) const;
    bool close(const TablePoint& a, const TablePoint& b) const;

    TableCells cells_;
    ErrorsAt errors_at_;
    std::vector<TablePoint> points_;
    std::vector<double> errors_;
};

}  // namespace nacre
