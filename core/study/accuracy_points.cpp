#include "core/study/accuracy_points.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

TableError together(const TableError& a, const TableError& b) {
    const int directions = a.directions + b.directions;
    const double squares = a.directions * a.root_mean_square * a.root_mean_square +
                           b.directions * b.root_mean_square * b.root_mean_square;
    return {std::max(a.worst, b.worst), directions > 0 ? std::sqrt(squares / directions) : 0, directions};
}

}  // namespace

std::vector<ShownPoint> shown_points(const MethodAccuracy& method, ChartOf quantity) {
    std::vector<ShownPoint> shown;
    for (const AccuracyPoint& point : method.points) {
        if ((point.quantity == Quantity::area) != (quantity == ChartOf::area)) continue;
        // R0 follows R1 of the same table.
        if (point.quantity == Quantity::albedo_f0)
            shown.back().error = together(shown.back().error, point.error);
        else
            shown.push_back({point.setting, point.seconds, point.bytes, point.error});
    }
    return shown;
}

}  // namespace nacre
