#include "core/formats/square_density.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace nacre {
namespace {

// Where the integral of a density that goes from `first` to `second` over [0, 1] reaches `area`.
double where_linear(double first, double second, double area) {
    const double root = std::sqrt(std::max(0.0, first * first + 2 * (second - first) * area));
    return first + root > 0 ? std::clamp(2 * area / (first + root), 0.0, 1.0) : 0;
}

// Its integral from 0 to `to`.
double area_linear(double first, double second, double to) {
    return to * (first + 0.5 * to * (second - first));
}

struct Cell {
    int index;
    double part;  // 0 to 1
};

// Of a grid of `count` nodes over [0, 1].
Cell cell_of(double at, int count) {
    const double place = at * (count - 1);
    const int index = std::clamp(static_cast<int>(place), 0, count - 2);
    return {index, place - index};
}

}  // namespace

SquareDensity::SquareDensity(glm::ivec2 size, std::vector<double> values)
    : size_(size),
      values_(std::move(values)),
      row_sums_(values_.size()),
      column_sums_(static_cast<std::size_t>(size.y)) {
    assert(size_.x > 1 && size_.y > 1 && values_.size() == static_cast<std::size_t>(size_.x * size_.y));
    const auto integrate = [&] {
        for (int y = 0; y < size_.y; ++y)
            for (int x = 1; x < size_.x; ++x)
                row_sums_[index(x, y)] =
                    row_sums_[index(x - 1, y)] + 0.5 * (value(x - 1, y) + value(x, y)) / (size_.x - 1);
        for (int y = 1; y < size_.y; ++y)
            column_sums_[static_cast<std::size_t>(y)] =
                column_sums_[static_cast<std::size_t>(y - 1)] +
                0.5 * (row_sums_[index(size_.x - 1, y - 1)] + row_sums_[index(size_.x - 1, y)]) /
                    (size_.y - 1);
    };
    integrate();
    const double all = column_sums_.back();
    assert(all > 0);
    for (double& v : values_) v /= all;
    integrate();
}

dvec2 SquareDensity::place(dvec2 uniform) const {
    const int last = size_.x - 1;
    const auto row = std::upper_bound(column_sums_.begin() + 1, column_sums_.end() - 1, uniform.y);
    const int y = static_cast<int>(row - column_sums_.begin()) - 1;
    const double r0 = row_sums_[index(last, y)], r1 = row_sums_[index(last, y + 1)];
    const double part =
        where_linear(r0, r1, (uniform.y - column_sums_[static_cast<std::size_t>(y)]) * (size_.y - 1));
    const auto mixed = [&](double first, double second) { return first + part * (second - first); };
    const double wanted = uniform.x * mixed(r0, r1);
    int low = 0, high = last;  // of the cell in which the integral of the row reaches it
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (mixed(row_sums_[index(middle, y)], row_sums_[index(middle, y + 1)]) <= wanted ? low : high) = middle;
    }
    const double before = mixed(row_sums_[index(low, y)], row_sums_[index(low, y + 1)]);
    const double in_cell =
        where_linear(mixed(value(low, y), value(low, y + 1)), mixed(value(low + 1, y), value(low + 1, y + 1)),
                     (wanted - before) * last);
    return {(low + in_cell) / last, (y + part) / (size_.y - 1)};
}

dvec2 MixedDensity::uniform(dvec2 at) const {
    const glm::ivec2 size = parts_.front().density->size();
    const int last = size.x - 1;
    const Cell x = cell_of(at.x, size.x), y = cell_of(at.y, size.y);
    const auto row = [&](int node) {
        return mean([&](const SquareDensity& d) { return d.row_sums_[d.index(last, node)]; });
    };
    const double r0 = row(y.index), r1 = row(y.index + 1);
    const auto along = [&](const SquareDensity& d, int node) {
        const double before = d.row_sums_[d.index(x.index, node)];
        return before + area_linear(d.value(x.index, node), d.value(x.index + 1, node), x.part) / last;
    };
    const double partial = mean([&](const SquareDensity& d) {
        return (1 - y.part) * along(d, y.index) + y.part * along(d, y.index + 1);
    });
    const double below =
        mean([&](const SquareDensity& d) { return d.column_sums_[static_cast<std::size_t>(y.index)]; });
    const double whole = r0 + y.part * (r1 - r0);
    return {whole > 0 ? partial / whole : 0, below + area_linear(r0, r1, y.part) / (size.y - 1)};
}

}  // namespace nacre
