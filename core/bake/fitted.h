// A table made larger or smaller until its measured error is what is wanted.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/bake/tables.h"

namespace nacre {

// A larger table is only taken if its error is at most this part of the smaller one's.
inline constexpr double worth_it = 0.9;

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
    auto better = [&](const auto& now, double wanted) {
        // The two axes rarely err most at the same place.
        const double sum = now.error.polar + now.error.azimuth;
        const double part = sum > 0 ? std::fmin(now.error.all.worst / sum, 1.0) : 1;
        return better_nodes(now.nodes, symmetry, part * now.error.polar, part * now.error.azimuth, wanted,
                            limit);
    };
    std::vector<TriedSize> tried;
    auto made = [&](TableNodes nodes) {
        auto result = make(nodes);
        tried.push_back({nodes, result.error.all.worst});
        return result;
    };
    auto best = made(first);
    constexpr int rounds = 6;
    for (int round = 0; round < rounds && best.error.all.worst > target; ++round) {
        TableNodes next = better(best, target);
        if (count(next) <= count(best.nodes)) next = better(best, 0.6 * target);
        // Fewer nodes along theta, and the error along it alone would be no better than all of it now.
        auto hopeless = [&](TableNodes nodes) {
            const double ratio = static_cast<double>(best.nodes.polar - 1) / (nodes.polar - 1);
            return ratio > 1 && ratio * ratio * best.error.polar > worth_it * best.error.all.worst;
        };
        auto larger = best;
        // What stands between both kinds of nodes may hide which axis it owes to: then the azimuth is tried.
        for (const TableNodes nodes : {next, more_azimuths(best.nodes, symmetry, limit)}) {
            if (count(nodes) <= count(best.nodes) || hopeless(nodes)) continue;
            larger = made(nodes);
            if (larger.error.all.worst <= worth_it * best.error.all.worst) break;
        }
        if (larger.error.all.worst > worth_it * best.error.all.worst) break;
        best = larger;
    }
    const TableNodes smaller = better(best, 0.8 * target);
    if (limit > 0 && best.error.all.worst <= target && 4 * count(smaller) <= 3 * count(best.nodes)) {
        const auto less = made(smaller);
        if (less.error.all.worst <= target) best = less;
    }
    best.tried = std::move(tried);
    return best;
}

}  // namespace nacre
