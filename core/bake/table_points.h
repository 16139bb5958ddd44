// Where a table is measured: between its nodes, and in the last cell before the horizon.
#pragma once

#include <vector>

#include "core/bake/table_size.h"

namespace nacre {

// At a node, half way between two along theta or along the azimuth, or between four.
enum class TablePlace { node, along_polar, along_azimuth, centre };

// A point of a table, in cells from its first node, and its place between nodes.
struct TablePoint {
    double column, row;
    TablePlace place;
};

// The cells between the nodes of one table.
class TableCells {
  public:
    TableCells(TableNodes nodes, Symmetry symmetry)
        : columns_(nodes.polar - 1),
          rows_(azimuth_cells(nodes.azimuth, symmetry)),
          nodes_azimuth_(nodes.azimuth) {}

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int count() const { return columns_ * rows_; }
    bool flat() const { return nodes_azimuth_ == 1; }        // one row of nodes: all points are along theta
    bool closed() const { return nodes_azimuth_ == rows_; }  // the last row is followed by the first

    // One of each place in cell row * columns() + column.
    std::vector<TablePoint> every_place_of(int cell) const;

    // One of each place in every cell.
    std::vector<TablePoint> every_place() const;

    // One in every cell, the places in turn.
    std::vector<TablePoint> one_a_cell() const;

    // This many, the places in turn, in cells scattered evenly (Roberts 2018, the R2 sequence).
    std::vector<TablePoint> scattered(int count) const;

    // This many within the last cell before the horizon, which may hold a layer thinner than itself.
    std::vector<TablePoint> grazing(int count) const;

    // One in each of the last three cells of every row, where R bends most.
    std::vector<TablePoint> near_horizon() const;

    // A comb within the last cell of each row, on the row and at so many parts of the way to the next: kinks
    // beside the horizon may be anywhere in the cell.
    std::vector<TablePoint> beside_horizon(int parts) const;

    // The cell that holds `point` and those that touch it.
    std::vector<int> cells_round(const TablePoint& point) const;

  private:
    TablePoint between(int cell, TablePlace place) const;
    TablePlace place_in_turn(int i) const;

    int columns_, rows_, nodes_azimuth_;
};

}  // namespace nacre
