#include "core/bake/worst_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nacre {
namespace {

// Of a climb: its first step, in cells, and how often it steps or halves its steps.
constexpr double first_step = 0.25;
constexpr int climb_rounds = 7;

// Within the last cell before the horizon a step of one cell is this many halvings of the distance to it,
// which ends here.
constexpr double halvings = 4, nearest = 1e-7;

}  // namespace

dvec3 not_below_lowest(dvec3 k) {
    if (k.z >= lowest_cosine) return k;
    const dvec2 e = glm::normalize(dvec2(k)) * std::sqrt((1 - lowest_cosine) * (1 + lowest_cosine));
    return {e, lowest_cosine};
}

std::vector<double> cell_bends(TableNodes nodes, Symmetry symmetry, const float* values,
                               const std::vector<double>& weights) {
    const TableCells cells(nodes, symmetry);
    const int columns = nodes.polar, rows = nodes.azimuth;
    auto value = [&](int column, int row) { return static_cast<double>(values[row * columns + column]); };
    // Past a mirror the rows come back.
    auto other_row = [&](int row) {
        if (cells.closed()) return (row + rows) % rows;
        return row < 0 ? -row : row >= rows ? 2 * (rows - 1) - row : row;
    };
    std::vector<double> bends(weights.size());
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int inner = std::clamp(column, 1, std::max(columns - 2, 1));
            double bend =
                columns < 3
                    ? std::fabs(value(1, row) - value(0, row))
                    : std::fabs(value(inner - 1, row) - 2 * value(inner, row) + value(inner + 1, row));
            if (!cells.flat())
                bend += std::fabs(value(column, other_row(row - 1)) - 2 * value(column, row) +
                                  value(column, other_row(row + 1)));
            const std::size_t at = static_cast<std::size_t>(row * columns + column);
            bends[at] = 0.125 * bend * weights[at];
        }
    std::vector<double> most(static_cast<std::size_t>(cells.count()), 0);
    for (int cell = 0; cell < cells.count(); ++cell)
        for (const int down : {0, 1})
            for (const int across : {0, 1}) {
                const int row = cells.flat() ? 0 : other_row(cell / cells.columns() + down);
                const int node = row * columns + cell % cells.columns() + across;
                double& worst = most[static_cast<std::size_t>(cell)];
                worst = worse_error(worst, bends[static_cast<std::size_t>(node)]);
            }
    return most;
}

void WorstSearch::look_at(const std::vector<TablePoint>& points) { know(points, errors_at_(points)); }

void WorstSearch::know(const std::vector<TablePoint>& points, const std::vector<double>& errors) {
    points_.insert(points_.end(), points.begin(), points.end());
    errors_.insert(errors_.end(), errors.begin(), errors.end());
}

void WorstSearch::look_at_bends(const std::vector<double>& bends, int count, bool between) {
    std::vector<int> order(bends.size());
    std::iota(order.begin(), order.end(), 0);
    const auto kept = order.begin() + std::min(count, static_cast<int>(order.size()));
    std::partial_sort(order.begin(), kept, order.end(), [&](int a, int b) {
        const double at = bends[static_cast<std::size_t>(a)], other = bends[static_cast<std::size_t>(b)];
        return at != other ? at > other : a < b;
    });
    std::vector<TablePoint> points;
    for (auto cell = order.begin(); cell != kept; ++cell) {
        if (between)
            for (const TablePoint& point : cells_.every_place_of(*cell)) points.push_back(point);
        // At a fold the largest error is near a corner as often as in the middle.
        const int turn = static_cast<int>(cell - order.begin());
        const int column = *cell % cells_.columns(), row = *cell / cells_.columns();
        points.push_back({column + (turn % 2 == 0 ? 0.25 : 0.75),
                          cells_.flat() ? 0 : row + (turn / 2 % 2 == 0 ? 0.25 : 0.75), TablePlace::centre});
    }
    look_at(points);
}

// Over a mirror or the normal no step leads further.
TablePoint WorstSearch::moved(const TablePoint& from, double across, double down) const {
    const double columns = cells_.columns(), rows = cells_.rows();
    TablePoint to{from.column + across, from.row + down, TablePlace::centre};
    const double rest = columns - from.column;
    if (rest < 1) to.column = columns - std::fmax(rest, nearest) * std::exp2(-halvings * across);
    to.column = std::clamp(to.column, 0.0, columns - nearest);
    if (cells_.flat())
        to.row = 0;
    else if (cells_.closed())
        to.row = std::fmod(to.row + rows, rows);
    else
        to.row = std::clamp(to.row, 0.0, rows);
    return to;
}

bool WorstSearch::close(const TablePoint& a, const TablePoint& b) const {
    const double rows = std::fabs(a.row - b.row);
    return std::fabs(a.column - b.column) < 1.5 &&
           (rows < 1.5 || (cells_.closed() && cells_.rows() - rows < 1.5));
}

std::vector<WorstSearch::Climb> WorstSearch::choose_starts(int count) const {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return errors_[a] != errors_[b] ? errors_[a] > errors_[b] : a < b;
    });
    std::vector<Climb> starts;
    for (const std::size_t i : order) {
        if (static_cast<int>(starts.size()) == count) break;
        if (std::none_of(starts.begin(), starts.end(),
                         [&](const Climb& other) { return close(other.point, points_[i]); }))
            starts.push_back({points_[i], errors_[i], first_step});
    }
    return starts;
}

void WorstSearch::climb(int starts) {
    std::vector<Climb> climbs = choose_starts(starts);
    const std::size_t ways = cells_.flat() ? 2 : 4;
    for (int round = 0; round < climb_rounds; ++round) {
        const std::size_t first = points_.size();
        std::vector<TablePoint> points;
        for (const Climb& climb : climbs) {
            points.push_back(moved(climb.point, climb.step, 0));
            points.push_back(moved(climb.point, -climb.step, 0));
            if (ways == 2) continue;
            points.push_back(moved(climb.point, 0, climb.step));
            points.push_back(moved(climb.point, 0, -climb.step));
        }
        look_at(points);
        for (std::size_t i = 0; i < climbs.size(); ++i) {
            bool higher = false;
            for (std::size_t at = first + i * ways; at < first + (i + 1) * ways; ++at) {
                if (!(errors_[at] > climbs[i].error)) continue;
                climbs[i].point = points_[at];
                climbs[i].error = errors_[at];
                higher = true;
            }
            if (!higher) climbs[i].step *= 0.5;
        }
    }
}

double WorstSearch::worst() const {
    double worst = 0;
    for (const double error : errors_) worst = worse_error(worst, error);
    return worst;
}

void WorstSearch::add_to(AxisError& error) const {
    error.all.worst = worse_error(error.all.worst, worst());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (points_[i].place == TablePlace::along_polar) error.polar = worse_error(error.polar, errors_[i]);
        if (points_[i].place == TablePlace::along_azimuth)
            error.azimuth = worse_error(error.azimuth, errors_[i]);
    }
}

}  // namespace nacre
