#include "core/geometry/polygon_sweep.h"

#include <algorithm>
#include <boost/intrusive/set.hpp>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/geometry/monotone_piece.h"

namespace nacre {
namespace {

using Triangle = std::array<std::size_t, 3>;

// So far from an edge, of a polygon whose size is about 1, a corner may lie on it.
constexpr double touching = 1e-12;

// A triangle may turn clockwise by this part of the polygon's area: its corners are rounded.
constexpr double rounded = 1e-12;

int sign_of(double value, double zero) { return value > zero ? 1 : value < -zero ? -1 : 0; }

// An interval of the sweep line inside the polygon, between two of its edges. Edge i runs from corner i to
// the next: to the right where the inside is above it, to the left where it is below.
struct Interval
    : boost::intrusive::set_base_hook<boost::intrusive::link_mode<boost::intrusive::normal_link>> {
    std::size_t low = 0, high = 0;  // edges
    MonotonePiece piece;
    // Where two intervals have met in a corner that is not joined to a later one yet: the upper one's.
    MonotonePiece upper;
    bool met = false;
};

// Two edges that begin in one corner and run to the right.
struct Wedge {
    glm::dvec2 tip, low, high;  // and their other ends
};

class PolygonSweep {
  public:
    explicit PolygonSweep(std::vector<glm::dvec2> points);
    PolygonSweep(const PolygonSweep&) = delete;
    PolygonSweep& operator=(const PolygonSweep&) = delete;

    // False where the polygon crosses itself.
    bool run();
    const std::vector<Triangle>& triangles() const { return triangles_; }
    std::size_t steps() const { return steps_ + triangles_.size(); }

  private:
    // In one place what ends comes before what begins, the inner before the outer, and what begins the other
    // way round.
    using Event = std::tuple<double, double, int, double, double, std::size_t>;

    bool right_of(std::size_t a, std::size_t b) const {
        return points_[a].x != points_[b].x ? points_[a].x > points_[b].x : points_[a].y > points_[b].y;
    }
    double turn_at(std::size_t i) const { return turn(points_[before_[i]], points_[i], points_[after_[i]]); }
    bool convex(std::size_t i) const { return turn_at(i) > 0; }

    void cut_needles();
    Event event_of(std::size_t i) const;
    bool pass(std::size_t i);
    bool end(std::size_t i);
    bool begin(std::size_t i);
    void arrive(Interval& interval, std::size_t corner, Chain chain);
    void split(Interval& below, std::size_t corner);
    int side(std::size_t edge, const Wedge& wedge);
    bool covers() const;

    std::vector<glm::dvec2> points_;
    std::vector<std::size_t> before_, after_, left_;
    std::deque<Interval> intervals_;
    std::vector<Interval*> of_edge_;
    boost::intrusive::set<Interval> status_;  // from below
    std::vector<Triangle> triangles_;
    std::size_t steps_ = 0;
};

PolygonSweep::PolygonSweep(std::vector<glm::dvec2> points)
    : points_(std::move(points)),
      before_(points_.size()),
      after_(points_.size()),
      of_edge_(points_.size(), nullptr) {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
        before_[i] = (i + n - 1) % n;
        after_[i] = (i + 1) % n;
    }
}

// Cuts off corners in the place of a neighbour and the tips of edges that are gone both ways, so that each
// that remains has a way to turn.
void PolygonSweep::cut_needles() {
    std::vector<bool> cut(points_.size());
    std::size_t count = points_.size(), i = 0;
    for (std::size_t seen = 0; seen < count && count > 3; ++steps_) {
        const std::size_t a = before_[i], c = after_[i];
        if (turn_at(i) != 0 || glm::dot(points_[a] - points_[i], points_[c] - points_[i]) < 0) {
            ++seen;
            i = c;
            continue;
        }
        triangles_.push_back({a, i, c});
        cut[i] = true;
        after_[a] = c;
        before_[c] = a;
        --count;
        seen = seen > 1 ? seen - 2 : 0;
        i = a;
    }
    for (std::size_t k = 0; k < points_.size(); ++k)
        if (!cut[k]) left_.push_back(k);
}

PolygonSweep::Event PolygonSweep::event_of(std::size_t i) const {
    const glm::dvec2 p = points_[i], in = points_[before_[i]] - p, out = points_[after_[i]] - p;
    const bool ends = right_of(i, before_[i]), ends_too = right_of(i, after_[i]);
    if (ends != ends_too) return {p.x, p.y, 1, 0, 0, i};
    auto slope = [&](glm::dvec2 to) { return std::atan2(to.y, ends ? -to.x : to.x); };
    const double a = slope(in), b = slope(out), low = std::fmin(a, b), high = std::fmax(a, b);
    return {p.x, p.y, ends ? 0 : 2, ends ? -low : low, ends ? high : -high, i};
}

// Whether the wedge lies above the edge (1) or below it (-1), which begins no later. On the edge itself it
// goes by where the wedge leads, on its line beyond an end, as only an upright edge has it, by that end.
int PolygonSweep::side(std::size_t edge, const Wedge& wedge) {
    ++steps_;
    glm::dvec2 a = points_[edge], b = points_[after_[edge]];
    if (right_of(edge, after_[edge])) std::swap(a, b);
    const double zero = touching * glm::length(b - a), at_tip = turn(a, b, wedge.tip);
    if (const int tip = sign_of(at_tip, zero); tip != 0) return tip;
    for (const auto& [near, far] : {std::pair(a, b), std::pair(b, a)})
        if (glm::dot(wedge.tip - near, far - near) < -zero) return sign_of(wedge.tip.y - near.y, 0);
    const int low = sign_of(turn(a, b, wedge.low), zero), high = sign_of(turn(a, b, wedge.high), zero);
    return low * high < 0 || low + high == 0 ? sign_of(at_tip, 0) : low + high > 0 ? 1 : -1;
}

// The corner on one of the interval's edges.
void PolygonSweep::arrive(Interval& interval, std::size_t corner, Chain chain) {
    if (interval.met) {
        if (chain == Chain::low) std::swap(interval.piece, interval.upper);
        interval.upper.close(corner, points_, triangles_);
        interval.met = false;
    }
    interval.piece.add(corner, chain, points_, triangles_);
}

// A corner where one edge follows the other.
bool PolygonSweep::pass(std::size_t i) {
    const bool to_right = right_of(i, before_[i]);
    const std::size_t ended = to_right ? before_[i] : i, begun = to_right ? i : before_[i];
    Interval* interval = of_edge_[ended];
    if (interval == nullptr) return false;
    arrive(*interval, i, to_right ? Chain::low : Chain::high);
    (to_right ? interval->low : interval->high) = begun;
    of_edge_[begun] = interval;
    return true;
}

// A corner where two edges end: of one interval, or of two that meet.
bool PolygonSweep::end(std::size_t i) {
    Interval *above = of_edge_[before_[i]], *below = of_edge_[i];
    if (above == nullptr || below == nullptr || (above == below) != convex(i)) return false;
    if (above == below) {
        above->piece.close(i, points_, triangles_);
        if (above->met) above->upper.close(i, points_, triangles_);
        status_.erase(status_.iterator_to(*above));
        return true;
    }
    const auto next = std::next(status_.iterator_to(*below));
    if (next == status_.end() || &*next != above) return false;
    arrive(*below, i, Chain::high);
    arrive(*above, i, Chain::low);
    below->upper = std::move(above->piece);
    below->met = true;
    below->high = above->high;
    of_edge_[below->high] = below;
    status_.erase(next);
    return true;
}

// A corner where two edges begin: a new interval, or one that is split.
bool PolygonSweep::begin(std::size_t i) {
    const bool is_split = !convex(i);
    const glm::dvec2 in = points_[before_[i]], out = points_[after_[i]];
    const Wedge wedge{points_[i], is_split ? in : out, is_split ? out : in};
    const auto place = status_.lower_bound(
        wedge, [&](const Interval& interval, const Wedge& w) { return side(interval.high, w) > 0; });
    if (!is_split) {
        if (place != status_.end() && side(place->low, wedge) >= 0) return false;
        Interval& added = intervals_.emplace_back();
        added.low = i;
        added.high = before_[i];
        added.piece = MonotonePiece(i);
        of_edge_[added.low] = of_edge_[added.high] = &added;
        status_.insert_before(place, added);
        return true;
    }
    if (place == status_.end() || side(place->low, wedge) <= 0 || side(place->high, wedge) >= 0) return false;
    split(*place, i);
    return true;
}

// Joined to the corner where the interval's edges met, or to its newest one.
void PolygonSweep::split(Interval& below, std::size_t corner) {
    Interval& above = intervals_.emplace_back();
    if (below.met) {
        above.piece = std::move(below.upper);
    } else if (const std::size_t newest = below.piece.newest(); below.piece.chain() == Chain::low) {
        above.piece = std::exchange(below.piece, MonotonePiece(newest));
    } else {
        above.piece = MonotonePiece(newest);
    }
    below.met = false;
    below.piece.add(corner, Chain::high, points_, triangles_);
    above.piece.add(corner, Chain::low, points_, triangles_);
    above.low = corner;
    above.high = below.high;
    below.high = before_[corner];
    of_edge_[above.low] = of_edge_[above.high] = &above;
    of_edge_[below.high] = &below;
    status_.insert_before(std::next(status_.iterator_to(below)), above);
}

// Whether all of it was cut, and no triangle turns the other way.
bool PolygonSweep::covers() const {
    if (triangles_.size() + 2 != points_.size()) return false;
    double whole = 0, least = 0;
    for (const auto& [a, b, c] : triangles_) {
        const double part = turn(points_[a], points_[b], points_[c]);
        whole += part;
        least = std::min(least, part);
    }
    return whole > 0 && least >= -rounded * whole;
}

bool PolygonSweep::run() {
    cut_needles();
    if (left_.size() == 3) {
        triangles_.push_back({left_[0], left_[1], left_[2]});
        return covers();
    }
    std::vector<Event> events;
    for (const std::size_t i : left_) events.push_back(event_of(i));
    std::sort(events.begin(), events.end());
    for (const Event& event : events) {
        ++steps_;
        const std::size_t i = std::get<5>(event);
        const int kind = std::get<2>(event);
        if (!(kind == 0 ? end(i) : kind == 1 ? pass(i) : begin(i))) return false;
    }
    return covers();
}

}  // namespace

// Where a corner is rounded over an edge that it touches, the sweep may pass them from another side.
bool sweep_polygon(std::span<const glm::dvec2> points, std::span<const std::size_t> corners,
                   std::vector<Triangle>& triangles, std::size_t& steps) {
    for (const bool turned : {false, true}) {
        std::vector<glm::dvec2> in_order;
        for (const std::size_t corner : corners) {
            const glm::dvec2 p = points[corner];
            in_order.push_back(turned ? glm::dvec2(p.y, -p.x) : p);
        }
        PolygonSweep sweep(std::move(in_order));
        const bool clean = sweep.run();
        steps += sweep.steps();
        if (!clean) continue;
        for (const auto& [a, b, c] : sweep.triangles())
            triangles.push_back({corners[a], corners[b], corners[c]});
        return true;
    }
    return false;
}

}  // namespace nacre
