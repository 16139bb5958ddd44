// A table made larger or smaller until its measured error is what is wanted.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/bake/tables.h"

namespace nacre {

// A larger table is only taken if its error is at most this part of the smaller one's.
inline constexpr double worth_it = 0.9;

// Less likely sizes are only tried for a table whose error is more than this times what is wanted.
inline constexpr double near_enough = 1.25;

template <class Table>
struct Fitted {
    std::shared_ptr<const Table> table;
    AxisError error;
    TableNodes nodes{};
    std::vector<TriedSize> tried;  // the one that was taken among them
};

// `make` gives the table of so many nodes with its error. The first table whose worst error is at most
// `target`, made smaller once where that promises to hold too; else the best within `limit` nodes; the first
// whatever its error with a limit of 0.
template <class Make>
auto fit_table(TableNodes first, Symmetry symmetry, double target, int limit, const Make& make) {
    auto count = [](TableNodes nodes) { return nodes.polar * nodes.azimuth; };
    auto cells = [&](TableNodes nodes) {
        return dvec2{nodes.polar - 1, azimuth_cells(nodes.azimuth, symmetry)};
    };
    std::vector<TriedSize> tried;
    // The most that any table erred away from the lines between nodes, for one cell along each axis: what
    // stands between both kinds of nodes hides which of them it owes to.
    dvec2 hidden{0};
    auto made = [&](TableNodes nodes) {
        auto result = make(nodes);
        const AxisError& error = result.error;
        tried.push_back({nodes, error.all.worst});
        hidden = glm::min(hidden, error.all.worst * cells(nodes) * cells(nodes));
        if (error.all.worst > std::fmax(error.polar, error.azimuth))
            hidden = glm::max(
                hidden, (error.all.worst - dvec2{error.azimuth, error.polar}) * cells(nodes) * cells(nodes));
        return result;
    };
    // Of a table along both axes. `blamed`: for what is hidden, (1, 0) the polar axis, (0, 1) the azimuth,
    // (1, 1) both.
    auto errors = [&](const auto& table, dvec2 blamed) {
        const dvec2 along = glm::max(dvec2{table.error.polar, table.error.azimuth},
                                     blamed * hidden / (cells(table.nodes) * cells(table.nodes)));
        // The two axes rarely err most at the same place.
        const double sum = along.x + along.y;
        return sum > 0 ? along * std::fmin(table.error.all.worst / sum, 1.0) : along;
    };
    auto better = [&](const auto& table, double wanted, dvec2 blamed) {
        const dvec2 along = errors(table, blamed);
        return better_nodes(table.nodes, symmetry, along.x, along.y, wanted, limit);
    };
    auto promises = [&](const auto& table, TableNodes nodes, dvec2 blamed) {
        const dvec2 ratio = cells(table.nodes) / cells(nodes), along = errors(table, blamed) * ratio * ratio;
        return along.x + along.y <= worth_it * table.error.all.worst;
    };
    auto known = [&](TableNodes nodes) {
        return std::any_of(tried.begin(), tried.end(),
                           [&](const TriedSize& size) { return size.nodes == nodes; });
    };
    auto best = made(first);
    constexpr int rounds = 6;
    for (int round = 0; round < rounds && best.error.all.worst > target; ++round) {
        auto other = best;
        for (const dvec2 blamed : {dvec2{0, 1}, dvec2{1, 1}, dvec2{1, 0}}) {
            TableNodes next = better(best, target, blamed);
            if (known(next)) next = better(best, 0.6 * target, blamed);
            if (known(next) || !promises(best, next, blamed)) continue;
            if (blamed.x > 0 && best.error.all.worst <= near_enough * target) continue;
            other = made(next);
            if (other.error.all.worst <= worth_it * best.error.all.worst) break;
        }
        if (other.error.all.worst > worth_it * best.error.all.worst) break;
        best = other;
    }
    const TableNodes smaller = better(best, 0.8 * target, dvec2{1});
    if (limit > 0 && best.error.all.worst <= target && 4 * count(smaller) <= 3 * count(best.nodes)) {
        const auto less = made(smaller);
        if (less.error.all.worst <= target) best = less;
    }
    best.tried = std::move(tried);
    return best;
}

}  // namespace nacre
