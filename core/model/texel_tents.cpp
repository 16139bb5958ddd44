#include "core/model/texel_tents.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <mutex>

#include "core/model/disk_quadrature.h"
#include "core/model/disk_texels.h"

namespace nacre {
namespace {

// The tent of a texel in one direction: from its middle to its neighbours', or flat on to the border.
double tent(int side, int index, double at) {
    const double off = (at - middle_of(side, index)) * 0.5 * side;
    if ((off > 0 && index == side - 1) || (off < 0 && index == 0)) return 1;
    return std::max(1 - std::fabs(off), 0.0);
}

Facet tent_facet(int side, int x, int y) {
    double weight = 0;
    dvec3 h{0};
    const double reach = 2.0 / side;
    const auto stops = [&](int index) {
        const double middle = middle_of(side, index);
        std::vector<double> all =
            cuts_between(std::max(middle - reach, -1.0), std::min(middle + reach, 1.0), 0);
        all.push_back(middle);
        std::sort(all.begin(), all.end());
        return all;
    };
    const std::vector<double> xs = stops(x), ys = stops(y);
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
        for (std::size_t j = 0; j + 1 < ys.size(); ++j)
            visit_in_disk({{xs[i], ys[j]}, {xs[i + 1], ys[j + 1]}}, [&](dvec2 at, double area) {
                const double part = 2 * area * tent(side, x, at.x) * tent(side, y, at.y);
                weight += part;
                h += part * disk_direction(at);
            });
    return weight > 0 ? Facet{h / weight, weight} : Facet{};
}

// How far from the middle a texel's middle is, in halves of a texel.
struct Offset {
    int x, y;

    static Offset of(int side, int row, int column) {
        return {std::abs(2 * column + 1 - side), std::abs(2 * row + 1 - side)};
    }
    bool tent_within(int side) const {
        const long a = x + 2L, b = y + 2L;
        return a * a + b * b <= static_cast<long>(side) * side;
    }
    bool tent_without(int side) const {
        const long a = std::max(x - 2, 0), b = std::max(y - 2, 0);
        return a * a + b * b >= static_cast<long>(side) * side;
    }
};

// h and half of the sum of its second derivatives along both axes.
dvec3 mean_over_tent(dvec2 at, double reach) {
    const double q = glm::dot(at, at), s = std::sqrt(2 - q);
    const double bend = -(4 / s + q / (s * s * s));
    return {at * (s + reach * reach / 12 * bend), 1 - q - reach * reach / 3};
}

}  // namespace

// Tents that the rim cuts, of the quadrant with x and y from 0 up; the others mirror them.
struct TexelTents::Rim {
    struct Row {
        int first = 0;  // column, counted from the middle
        std::vector<Facet> tents;
    };
    std::vector<Row> rows;

    explicit Rim(int side) : rows(static_cast<std::size_t>((side + 1) / 2)) {
        tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
            const int middle = side / 2, at = middle + static_cast<int>(i);
            Row& row = rows[i];
            for (int column = middle; column < side; ++column) {
                const Offset offset = Offset::of(side, side - 1 - at, column);
                if (offset.tent_within(side)) row.first = column - middle + 1;
                if (offset.tent_within(side) || offset.tent_without(side)) continue;
                row.tents.push_back(tent_facet(side, column, at));
            }
        });
    }
};

// The latest few sides stay: a brush asks again and again.
std::shared_ptr<const TexelTents::Rim> TexelTents::rim_of(int side) {
    static std::mutex mutex;
    static std::map<int, std::weak_ptr<const Rim>> known;
    static std::shared_ptr<const Rim> latest;
    const std::lock_guard lock(mutex);
    std::shared_ptr<const Rim> rim = known[side].lock();
    if (!rim) known[side] = rim = std::make_shared<const Rim>(side);
    latest = rim;
    return rim;
}

TexelTents::TexelTents(int side) : side_(side), rim_(rim_of(side)) {}

namespace {

// Sums over the cells between middles, each of which adds to the tents at its corners.
class FactorSums {
  public:
    struct Tent {
        double weight = 0;
        dvec2 moment{0};
    };

    FactorSums(int side, const TexelTents::FactorAt& factor, int factor_side) : side_(side), factor_(factor) {
        for (int i = 0; i <= side; ++i)
            cuts_.push_back(cuts_between(i == 0 ? -1 : middle_of(side, i - 1),
                                         i == side ? 1 : middle_of(side, i), factor_side));
    }

    // Rows of tents from the bottom, the end not included.
    std::vector<Tent> rows(int begin, int end) const {
        std::vector<Tent> tents(static_cast<std::size_t>(end - begin) * static_cast<std::size_t>(side_));
        for (int y = begin; y <= end; ++y)
            for (int x = 0; x <= side_; ++x) add_cell(x, y, begin, end, tents);
        return tents;
    }

  private:
    // The cell between tents x - 1 and x, y - 1 and y.
    void add_cell(int x, int y, int begin, int end, std::vector<Tent>& tents) const {
        const std::vector<double>& xs = cuts_[static_cast<std::size_t>(x)];
        const std::vector<double>& ys = cuts_[static_cast<std::size_t>(y)];
        Tent corner[2][2];
        for (std::size_t i = 0; i + 1 < ys.size(); ++i)
            for (std::size_t j = 0; j + 1 < xs.size(); ++j)
                visit_in_disk({{xs[j], ys[i]}, {xs[j + 1], ys[i + 1]}}, [&](dvec2 at, double area) {
                    const double whole = 2 * area * factor_(at);
                    const double right = part_of_second(xs, x, at.x), upper = part_of_second(ys, y, at.y);
                    for (int up = 0; up < 2; ++up)
                        for (int over = 0; over < 2; ++over) {
                            const double part = whole * (over ? right : 1 - right) * (up ? upper : 1 - upper);
                            corner[up][over].weight += part;
                            corner[up][over].moment += part * at;
                        }
                });
        for (int up = 0; up < 2; ++up)
            for (int over = 0; over < 2; ++over) {
                const int row = y - 1 + up, column = x - 1 + over;
                if (row < begin || row >= end || column < 0 || column >= side_) continue;
                Tent& tent = tents[static_cast<std::size_t>(row - begin) * static_cast<std::size_t>(side_) +
                                   static_cast<std::size_t>(column)];
                tent.weight += corner[up][over].weight;
                tent.moment += corner[up][over].moment;
            }
    }

    // Of the tent at a cell's upper end, at a place between both.
    double part_of_second(const std::vector<double>& ends, int index, double at) const {
        if (index == 0) return 1;
        if (index == side_) return 0;
        return (at - ends.front()) * 0.5 * side_;
    }

    int side_;
    const TexelTents::FactorAt& factor_;
    std::vector<std::vector<double>> cuts_;
};

}  // namespace

TexelTents::TexelTents(int side, const FactorAt& factor, int factor_side) : side_(side) {
    constexpr int rows_at_once = 32;
    auto all = std::make_shared<std::vector<std::array<float, 3>>>(static_cast<std::size_t>(side) *
                                                                   static_cast<std::size_t>(side));
    const FactorSums sums(side, factor, factor_side);
    tbb::parallel_for(0, (side + rows_at_once - 1) / rows_at_once, [&](int band) {
        const int begin = band * rows_at_once, end = std::min(begin + rows_at_once, side);
        const std::vector<FactorSums::Tent> tents = sums.rows(begin, end);
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < side; ++x) {
                const FactorSums::Tent& tent =
                    tents[static_cast<std::size_t>(y - begin) * static_cast<std::size_t>(side) +
                          static_cast<std::size_t>(x)];
                if (!(tent.weight > 0)) continue;
                const dvec2 at = tent.moment / tent.weight;
                (*all)[static_cast<std::size_t>(side - 1 - y) * static_cast<std::size_t>(side) +
                       static_cast<std::size_t>(x)] = {static_cast<float>(at.x), static_cast<float>(at.y),
                                                       static_cast<float>(tent.weight)};
            }
    });
    all_ = std::move(all);
}

Facet TexelTents::operator()(int row, int column) const {
    if (all_) {
        const auto& [x, y, weight] = (*all_)[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                                             static_cast<std::size_t>(column)];
        return {mean_over_tent({x, y}, reach()), static_cast<double>(weight)};
    }
    const Offset offset = Offset::of(side_, row, column);
    if (offset.tent_within(side_))
        return {mean_over_tent(texel_point(side_, row, column), reach()), texel_solid_angle(side_)};
    if (offset.tent_without(side_)) return {};
    const Rim::Row& of_row = rim_->rows[static_cast<std::size_t>(offset.y / 2)];
    Facet facet = of_row.tents[static_cast<std::size_t>(offset.x / 2 - of_row.first)];
    if (2 * column + 1 < side_) facet.h.x = -facet.h.x;
    if (2 * row + 1 > side_) facet.h.y = -facet.h.y;
    return facet;
}

}  // namespace nacre
