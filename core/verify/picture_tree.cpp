#include "core/verify/picture_tree.h"

#include <cmath>
#include <numeric>
#include <unordered_map>

#include "core/model/picture_lobe.h"
#include "core/model/span_facet.h"

namespace nacre {
namespace {

constexpr std::size_t points = PictureTree::points;

// A box that holds more than this part of its lobe is split further than usual.
constexpr double heavy_part = 1.0 / 4096;

// From so many of the lobe's points in a box on they stand for p there; of fewer, some on its border would
// make much of it.
constexpr std::size_t many_points = 64;

constexpr int usual_side = 1 << PictureTree::usual_level;

// Gauss's four points on [0, 1].
const std::array<double, points>& nodes() {
    static const std::array<double, points> places = [] {
        const double near = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2));
        const double far = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
        return std::array{0.5 - 0.5 * far, 0.5 - 0.5 * near, 0.5 + 0.5 * near, 0.5 + 0.5 * far};
    }();
    return places;
}

// The cubics that are 1 at one of the points and 0 at the others.
std::array<double, points> cubics(double x) {
    std::array<double, points> values;
    for (std::size_t i = 0; i < points; ++i) {
        values[i] = 1;
        for (std::size_t j = 0; j < points; ++j)
            if (j != i) values[i] *= (x - nodes()[j]) / (nodes()[i] - nodes()[j]);
    }
    return values;
}

using Weight = std::array<double, PictureTree::weights>;

void add_product(Weight& weight, const std::array<double, points>& x, const std::array<double, points>& y,
                 double mass) {
    for (std::size_t i = 0; i < points; ++i)
        for (std::size_t j = 0; j < points; ++j) weight[points * i + j] += mass * y[i] * x[j];
}

void add_point(Weight& weight, const Box& box, dvec2 at, double mass) {
    const dvec2 place = (at - box.low) / (box.high - box.low);
    add_product(weight, cubics(place.x), cubics(place.y), mass);
}

double mass_of(const Weight& weight) { return std::accumulate(weight.begin(), weight.end(), 0.0); }

// The usual level's box that holds a place, as column and row.
std::size_t bin_of(dvec2 at) {
    const dvec2 box = glm::clamp(glm::floor(0.5 * usual_side * (at + 1.0)), 0.0, usual_side - 1.0);
    return static_cast<std::size_t>(box.y) * usual_side + static_cast<std::size_t>(box.x);
}

Box box_at(int level, std::size_t column, std::size_t row) {
    const double size = std::exp2(1 - level);
    const dvec2 low = size * dvec2(static_cast<double>(column), static_cast<double>(row)) - 1.0;
    return {low, low + size};
}

}  // namespace

// The usual level's boxes, row by row. Where one is heavy each is filled as those that are split further.
struct PictureTree::Bins {
    std::vector<Weight> weight = std::vector<Weight>(std::size_t{usual_side} * usual_side);
    std::vector<std::size_t> count = std::vector<std::size_t>(weight.size());
    std::unordered_map<std::size_t, std::vector<Point>> heavy;  // and the points in them
};

Box PictureTree::first_box(std::size_t cell) {
    constexpr std::size_t side = std::size_t{1} << first_level;
    return box_at(first_level, cell % side, cell / side);
}

Box PictureTree::child_box(const Box& box, std::size_t child) {
    const dvec2 half = 0.5 * (box.high - box.low);
    const dvec2 low = box.low + half * dvec2(child % 2, child / 2);
    return {low, low + half};
}

dvec3 PictureTree::direction(const Box& box, std::size_t point) const {
    const dvec2 place(nodes()[point % points], nodes()[point / points]);
    const dvec3 own = disk_direction(box.low + place * (box.high - box.low));
    return placed_.frame *
           glm::normalize(dvec3(own.x * span_.stretch.x, own.y * span_.stretch.y, own.z * span_.flip));
}

// Of the hemisphere alone.
template <class Visit>
void PictureTree::visit_points(const Visit& visit) const {
    placed_.lobe->visit_points([&](const Facet& facet) {
        if (facet.h.z * span_.flip < 0) return;
        const dvec3 own(facet.h.x / span_.stretch.x, facet.h.y / span_.stretch.y, facet.h.z * span_.flip);
        visit(Point{disk_point(glm::normalize(own)), placed_.scale * facet.mass});
    });
}

PictureTree::PictureTree(const PlacedLobe& placed, const LobeParameterization& span)
    : placed_(placed),
      span_(span),
      sides_(picture_sides(*placed.lobe)),
      heavy_(heavy_part * placed.scale * placed.lobe->mass()),
      cells_(first_count()) {
    Bins bins;
    visit_points([&](const Point& point) {
        const std::size_t bin = bin_of(point.at);
        add_point(bins.weight[bin], box_at(usual_level, bin % usual_side, bin / usual_side), point.at,
                  point.mass);
        ++bins.count[bin];
    });
    for (std::size_t bin = 0; bin < bins.weight.size(); ++bin)
        if (mass_of(bins.weight[bin]) > heavy_) bins.heavy[bin];
    if (!bins.heavy.empty())
        visit_points([&](const Point& point) {
            const auto found = bins.heavy.find(bin_of(point.at));
            if (found != bins.heavy.end()) found->second.push_back(point);
        });
    for (std::size_t cell = 0; cell < first_count(); ++cell) grow(cell, first_box(cell), first_level, bins);
}

std::size_t PictureTree::add_children(std::size_t cell) {
    const std::size_t first = cells_.size();
    cells_[cell].children = first;
    cells_.resize(first + 4);
    return first;
}

void PictureTree::grow(std::size_t cell, const Box& box, int level, const Bins& bins) {
    if (level == usual_level) {
        const std::size_t bin = bin_of(0.5 * (box.low + box.high));
        if (bins.heavy.empty() || bins.count[bin] >= many_points)
            cells_[cell].weight = bins.weight[bin];
        else
            fill(cells_[cell], box);
        if (bins.heavy.empty() || mass_of(cells_[cell].weight) <= heavy_) return;
        const auto found = bins.heavy.find(bin);
        part(cell, box, level, found == bins.heavy.end() ? std::vector<Point>() : found->second);
        return;
    }
    const std::size_t first = add_children(cell);
    for (std::size_t i = 0; i < 4; ++i) grow(first + i, child_box(box, i), level + 1, bins);
    add_up(cell);
}

void PictureTree::part(std::size_t cell, const Box& box, int level, const std::vector<Point>& inside) {
    const std::size_t first = add_children(cell);
    for (std::size_t i = 0; i < 4; ++i) {
        const Box child = child_box(box, i);
        std::vector<Point> points_in;
        std::copy_if(inside.begin(), inside.end(), std::back_inserter(points_in), [&](const Point& point) {
            return glm::all(glm::greaterThanEqual(point.at, child.low)) &&
                   glm::all(glm::lessThan(point.at, child.high));
        });
        Cell& made = cells_[first + i];
        if (points_in.size() >= many_points)
            for (const Point& point : points_in) add_point(made.weight, child, point.at, point.mass);
        else
            fill(made, child);
        if (level + 1 < last_level && mass_of(made.weight) > heavy_)
            part(first + i, child, level + 1, points_in);
    }
    add_up(cell);
}

// The box is cut where p has corners, or where those lines are not known into more parts.
void PictureTree::fill(Cell& cell, const Box& box) const {
    const int parts = sides_.empty() ? 4 : 2;
    std::array<std::vector<double>, 2> stops;
    for (int axis = 0; axis < 2; ++axis) {
        std::vector<double>& all = stops[static_cast<std::size_t>(axis)];
        for (int i = 0; i <= parts; ++i)
            all.push_back(box.low[axis] + (box.high[axis] - box.low[axis]) * i / parts);
        for (const int side : sides_)
            for (const double cut : cuts_between(box.low[axis], box.high[axis], side)) all.push_back(cut);
        std::sort(all.begin(), all.end());
    }
    const auto& [x, y] = stops;
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        for (std::size_t j = 0; j + 1 < y.size(); ++j)
            if (x[i + 1] > x[i] && y[j + 1] > y[j])
                visit_in_disk({{x[i], y[j]}, {x[i + 1], y[j + 1]}}, [&](dvec2 at, double area) {
                    const dvec3 own = disk_direction(at);
                    const SpanPoint point = span_point(span_, own.z, glm::normalize(dvec2(own)));
                    const double p = placed_.scale * placed_.lobe->density(point.h);
                    if (p > 0) add_point(cell.weight, box, at, p * point.solid_angle * 2 * area);
                });
}

// A parent's cubics are cubics on each child, so that the child's points give their integrals.
void PictureTree::add_up(std::size_t cell) {
    static const auto cubic = [] {
        std::array<std::array<std::array<double, points>, points>, 2> values;  // of half, at its point
        for (std::size_t half = 0; half < 2; ++half)
            for (std::size_t a = 0; a < points; ++a)
                values[half][a] = cubics(0.5 * (static_cast<double>(half) + nodes()[a]));
        return values;
    }();
    Cell& parent = cells_[cell];
    parent.weight = {};
    for (std::size_t child = 0; child < 4; ++child)
        for (std::size_t point = 0; point < weights; ++point) {
            const double mass = cells_[parent.children + child].weight[point];
            if (mass == 0) continue;
            add_product(parent.weight, cubic[child % 2][point % points], cubic[child / 2][point / points],
                        mass);
        }
    if (!parent.empty()) return;
    cells_.resize(parent.children);
    cells_[cell].children = 0;
}

}  // namespace nacre
