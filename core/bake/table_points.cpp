#include "core/bake/table_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr TablePlace places[] = {TablePlace::along_polar, TablePlace::along_azimuth, TablePlace::centre};

int strewn_cell(int i, int columns, int rows) {
    const double plastic = 1.32471795724474602596;
    const double x = std::fmod(0.5 + (i + 1) / plastic, 1.0);
    const double y = std::fmod(0.5 + (i + 1) / (plastic * plastic), 1.0);
    return static_cast<int>(y * rows) * columns + static_cast<int>(x * columns);
}

}  // namespace

TablePlace TableCells::place_in_turn(int i) const { return flat() ? TablePlace::along_polar : places[i % 3]; }

TablePoint TableCells::between(int cell, TablePlace place) const {
    return {cell % columns_ + (place == TablePlace::along_azimuth ? 1 : 0.5),
            cell / columns_ + (place == TablePlace::along_polar ? 0 : 0.5), place};
}

std::vector<TablePoint> TableCells::every_place_of(int cell) const {
    if (flat()) return {between(cell, TablePlace::along_polar)};
    std::vector<TablePoint> points;
    for (const TablePlace place : places) points.push_back(between(cell, place));
    return points;
}

std::vector<TablePoint> TableCells::every_place() const {
    std::vector<TablePoint> points;
    for (int cell = 0; cell < count(); ++cell)
        for (const TablePoint& point : every_place_of(cell)) points.push_back(point);
    return points;
}

std::vector<TablePoint> TableCells::one_a_cell() const {
    std::vector<TablePoint> points;
    for (int cell = 0; cell < count(); ++cell) points.push_back(between(cell, place_in_turn(cell)));
    return points;
}

std::vector<TablePoint> TableCells::scattered(int count) const {
    std::vector<TablePoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back(between(strewn_cell(i, columns_, rows_), place_in_turn(i)));
    return points;
}

std::vector<TablePoint> TableCells::grazing(int count) const {
    std::vector<TablePoint> points;
    for (int i = 0; i < count; ++i)
        points.push_back({columns_ - std::exp2(-2 - i % 12),
                          flat() ? 0 : rows_ * std::fmod((i + 0.5) * std::numbers::phi, 1.0),
                          TablePlace::centre});
    return points;
}

std::vector<TablePoint> TableCells::near_horizon() const {
    std::vector<TablePoint> points;
    for (int row = 0; row < rows_; ++row)
        for (int cell = 1; cell <= std::min(3, columns_); ++cell)
            points.push_back({columns_ - cell + 0.5,
                              flat() ? 0 : row + std::fmod((row + cell) * std::numbers::phi, 1.0),
                              TablePlace::centre});
    return points;
}

std::vector<TablePoint> TableCells::beside_horizon(int parts) const {
    std::vector<TablePoint> points;
    const int last = flat() ? 0 : parts * rows_ - (closed() ? 1 : 0);
    for (int part = 0; part <= last; ++part)
        for (const double beside : {0.2, 0.1, 0.05, 0.02, 0.01, 0.003})
            points.push_back({columns_ - beside, static_cast<double>(part) / parts, TablePlace::centre});
    return points;
}

std::vector<int> TableCells::cells_round(const TablePoint& point) const {
    std::vector<int> cells;
    for (int down = -1; down <= 1; ++down)
        for (int across = -1; across <= 1; ++across) {
            const int column = static_cast<int>(point.column) + across;
            int row = static_cast<int>(point.row) + down;
            if (closed()) row = (row + rows_) % rows_;
            if (column >= 0 && column < columns_ && row >= 0 && row < rows_)
                cells.push_back(row * columns_ + column);
        }
    return cells;
}

}  // namespace nacre
