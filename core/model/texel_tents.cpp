#include "core/model/texel_tents.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <mutex>
#include <numbers>

#include "core/model/disk_texels.h"
#include "core/model/quadrature.h"

namespace nacre {
namespace {

// A rectangle on the disk's plane.
struct Box {
    dvec2 low, high;
};

// Over larger ones h and the rim bend too much for the rules below.
constexpr double largest_box = 1.0 / 60;

// visit(at, weight) over the box with two points of Gauss a side: exact for cubics in x and in y.
template <class Visit>
void visit_box(const Box& box, const Visit& visit) {
    const dvec2 middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
    const dvec2 off = half * std::numbers::inv_sqrt3;
    for (const double x : {middle.x - off.x, middle.x + off.x})
        for (const double y : {middle.y - off.y, middle.y + off.y}) visit(dvec2(x, y), half.x * half.y);
}

// The same over the part of a box in a quadrant of the plane that lies within the disk. Lines run along the
// axis that they meet the rim more squarely by, and the box is cut where the rim enters or leaves it.
template <class Visit>
void visit_in_disk(const Box& box, const Visit& visit) {
    const dvec2 middle = 0.5 * (box.low + box.high);
    const dvec2 sign(middle.x < 0 ? -1 : 1, middle.y < 0 ? -1 : 1);
    const dvec2 a = glm::min(sign * box.low, sign * box.high), b = glm::max(sign * box.low, sign * box.high);
    if (glm::dot(a, a) >= 1) return;
    if (std::max(b.x - a.x, b.y - a.y) > largest_box) {
        for (int i = 0; i < 4; ++i) {
            const dvec2 quarter(i % 2, i / 2), half = 0.5 * (box.high - box.low);
            visit_in_disk({box.low + quarter * half, middle + quarter * half}, visit);
        }
        return;
    }
    if (glm::dot(b, b) <= 1) return visit_box(box, visit);
    const int inner = a.x + b.x > a.y + b.y ? 0 : 1, outer = 1 - inner;
    const auto rim = [](double along) { return std::sqrt(std::max(1 - along * along, 0.0)); };
    const double end = std::min(b[outer], rim(a[inner]));
    const double turn = std::clamp(rim(std::min(b[inner], 1.0)), a[outer], end);
    const auto& rule = gauss_legendre<7>();
    const auto over = [&](double from, double to) {
        if (!(to > from)) return;
        for (const QuadraturePoint& s : rule) {
            const double along = from + (to - from) * s.x;
            const double length = std::min(b[inner], rim(along)) - a[inner];
            for (const QuadraturePoint& t : rule) {
                dvec2 at;
                at[outer] = along;
                at[inner] = a[inner] + length * t.x;
                visit(sign * at, (to - from) * s.weight * length * t.weight);
            }
        }
    };
    over(a[outer], turn);
    over(turn, end);
}

double middle_of(int side, int index) { return (2.0 * index + 1 - side) / side; }

// The pieces of [low, high] between the middles of a picture's texels, and 0, where quadrants meet.
std::vector<double> cuts(double low, double high, int side) {
    std::vector<double> at = {low};
    if (side > 0) {
        const double slack = 1e-9 / side;
        const int first = std::max(static_cast<int>(std::floor((low + 1) / 2 * side - 0.5)), 0);
        for (int i = first; i < side && middle_of(side, i) < high - slack; ++i)
            if (middle_of(side, i) > low + slack) at.push_back(middle_of(side, i));
    }
    if (low < 0 && high > 0) at.push_back(0);
    at.push_back(high);
    std::sort(at.begin(), at.end());
    return at;
}

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
        std::vector<double> all = cuts(std::max(middle - reach, -1.0), std::min(middle + reach, 1.0), 0);
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

void visit_disk(int side, int other_side, const std::function<void(dvec2 at, double solid_angle)>& visit) {
    std::vector<double> stops;
    for (const int of : {side, other_side}) {
        const std::vector<double> part = cuts(-1, 1, of);
        stops.insert(stops.end(), part.begin(), part.end());
    }
    std::sort(stops.begin(), stops.end());
    const auto same = [](double a, double b) { return b - a < 1e-12; };
    stops.erase(std::unique(stops.begin(), stops.end(), same), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
        for (std::size_t j = 0; j + 1 < stops.size(); ++j)
            visit_in_disk({{stops[j], stops[i]}, {stops[j + 1], stops[i + 1]}},
                          [&](dvec2 at, double area) { visit(at, 2 * area); });
}

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
            cuts_.push_back(
                cuts(i == 0 ? -1 : middle_of(side, i - 1), i == side ? 1 : middle_of(side, i), factor_side));
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

Spread& Spread::operator+=(const Spread& other) {
    xx += other.xx, yy += other.yy, zz += other.zz;
    xy += other.xy, xz += other.xz, yz += other.yz;
    return *this;
}

double Spread::half_width() const {
    const double trace = xx + yy + zz;
    const double squares = xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz);
    return std::sqrt(0.5 * (trace + std::sqrt(std::max(2 * squares - trace * trace, 0.0))));
}

Spread spread_along(dvec3 u) { return {u.x * u.x, u.y * u.y, u.z * u.z, u.x * u.y, u.x * u.z, u.y * u.z}; }

Spread spread_on_disk(dvec2 at, double reach) {
    at *= std::min(1.0, 1 / std::max(glm::length(at), 1e-30));
    const double s = std::sqrt(2 - glm::dot(at, at));
    Spread spread = spread_along(reach * dvec3(s - at.x * at.x / s, -at.x * at.y / s, -2 * at.x));
    spread += spread_along(reach * dvec3(-at.x * at.y / s, s - at.y * at.y / s, -2 * at.y));
    return spread;
}

}  // namespace nacre
