// Chooses the size of a table so that its measured error meets a tolerance.
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

// Less likely sizes are only tried for a table whose error is more than this times the target.
inline constexpr double near_enough = 1.25;

template <class Table>
struct Fitted {
    std::shared_ptr<const Table> table;
    AxisError error;
    TableNodes nodes{};
    bool kept = false;  // the errors are within the target; false where any size would do
};

// What is asked of a table.
struct FitWishes {
    double target;     // error at the directions between the table's own nodes
    double tolerance;  // error at any direction at which the table is measured
    int limit;         // nodes; 0: the first table, whatever its error
    int most;          // nodes, where `limit` does not meet the tolerance
};

// Finds the size of one table. `maker` knows how: make(nodes) gives a Fitted with the error between its
// nodes; search(fitted) looks for the largest error and raises the table's error to that; shared(fitted) is
// the worst error at all the directions that any table was ever measured at, so that two tables are compared
// by the same ones.
template <class Maker>
class TableFit {
  public:
    using Result = typename Maker::Result;

    TableFit(Maker& maker, Symmetry symmetry, const FitWishes& wishes)
        : maker_(maker), symmetry_(symmetry), wishes_(wishes) {}

    // The first table whose error between its nodes is at most the target, made smaller once where that
    // promises to hold too; else the best within the limit. Then it is searched.
    Result within_limit(TableNodes first) {
        tried_.clear();
        made_.clear();
        hidden_ = dvec2{0};
        Result best = made(first);
        constexpr int rounds = 6;
        for (int round = 0; round < rounds && best.error.all.worst > wishes_.target; ++round)
            if (!grow(best, wishes_.limit)) break;
        const TableNodes smaller = better(best, 0.8 * wishes_.target, dvec2{1}, wishes_.limit);
        if (wishes_.limit > 0 && best.error.all.worst <= wishes_.target &&
            4 * count(smaller) <= 3 * count(best.nodes)) {
            const Result less = made(smaller);
            if (less.error.all.worst <= wishes_.target) best = less;
        }
        const bool kept = wishes_.limit > 0 && best.error.all.worst <= wishes_.target;
        search(best);
        if (best.error.all.worst > wishes_.tolerance) look_back(best);
        best.kept = kept && best.error.all.worst <= wishes_.tolerance;
        return best;
    }

    // Grown until it keeps to the tolerance wherever it was looked at, or no larger table promises to.
    Result beyond(Result best) {
        searching_ = true;
        constexpr int rounds = 3;
        for (int round = 0; round < rounds && best.error.all.worst > wishes_.tolerance; ++round) {
            const TableNodes within = better(best, wishes_.target, dvec2{1}, wishes_.limit);
            const bool suffices = expected(best, within, dvec2{1}) <= wishes_.tolerance;
            if (!grow(best, suffices ? wishes_.limit : wishes_.most)) break;
        }
        return best;
    }

    // All that were made.
    const std::vector<TriedSize>& tried() const { return tried_; }

  private:
    static int count(TableNodes nodes) { return nodes.polar * nodes.azimuth; }

    dvec2 cells(TableNodes nodes) const {
        return dvec2{nodes.polar - 1, azimuth_cells(nodes.azimuth, symmetry_)};
    }

    Result made(TableNodes nodes) {
        Result result = maker_.make(nodes);
        tried_.push_back({nodes, result.error.all.worst});
        searching_ ? search(result) : learn(result);
        made_.push_back(result);
        return result;
    }

    // A table that was passed over may have the smaller error where the chosen one is worst.
    void look_back(Result& best) {
        for (Result other : made_) {
            if (other.nodes == best.nodes || maker_.shared(other) >= worth_it * best.error.all.worst)
                continue;
            search(other);
            if (other.error.all.worst < best.error.all.worst) best = std::move(other);
        }
    }

    void search(Result& result) {
        maker_.search(result);
        for (TriedSize& size : tried_)
            if (size.nodes == result.nodes) size.worst = result.error.all.worst;
        learn(result);
    }

    void learn(const Result& result) {
        const AxisError& error = result.error;
        const dvec2 square = cells(result.nodes) * cells(result.nodes);
        hidden_ = glm::min(hidden_, error.all.worst * square);
        if (error.all.worst > std::fmax(error.polar, error.azimuth))
            hidden_ = glm::max(hidden_, (error.all.worst - dvec2{error.azimuth, error.polar}) * square);
    }

    // Of a table along both axes. `blamed`: for what is hidden, (1, 0) the polar axis, (0, 1) the azimuth,
    // (1, 1) both.
    dvec2 errors(const Result& table, dvec2 blamed) const {
        const dvec2 along = glm::max(dvec2{table.error.polar, table.error.azimuth},
                                     blamed * hidden_ / (cells(table.nodes) * cells(table.nodes)));
        // The largest errors of the two axes are rarely at the same place.
        const double sum = along.x + along.y;
        return sum > 0 ? along * std::fmin(table.error.all.worst / sum, 1.0) : along;
    }

    TableNodes better(const Result& table, double wanted, dvec2 blamed, int limit) const {
        const dvec2 along = errors(table, blamed);
        return better_nodes(table.nodes, symmetry_, along.x, along.y, wanted, limit);
    }

    // The error expected of a table with `nodes`.
    double expected(const Result& table, TableNodes nodes, dvec2 blamed) const {
        const dvec2 ratio = cells(table.nodes) / cells(nodes), along = errors(table, blamed) * ratio * ratio;
        return along.x + along.y;
    }

    bool known(TableNodes nodes) const {
        return std::any_of(tried_.begin(), tried_.end(),
                           [&](const TriedSize& size) { return size.nodes == nodes; });
    }

    // Whether a table was found that is worth it.
    bool grow(Result& best, int limit) {
        for (const dvec2 blamed : {dvec2{0, 1}, dvec2{1, 1}, dvec2{1, 0}}) {
            TableNodes next = better(best, wishes_.target, blamed, limit);
            if (known(next)) next = better(best, 0.6 * wishes_.target, blamed, limit);
            if (known(next) || expected(best, next, blamed) > worth_it * best.error.all.worst) continue;
            if (blamed.x > 0 && best.error.all.worst <= near_enough * wishes_.target) continue;
            Result other = made(next);
            if (maker_.shared(other) > worth_it * maker_.shared(best)) continue;
            best = std::move(other);
            return true;
        }
        return false;
    }

    Maker& maker_;
    Symmetry symmetry_;
    FitWishes wishes_;
    std::vector<TriedSize> tried_;
    std::vector<Result> made_;
    bool searching_ = false;  // each table that is made
    // The largest error of any table away from the lines between nodes, for
    // one cell along each axis: it may come from either axis.
    dvec2 hidden_{0};
};

}  // namespace nacre
