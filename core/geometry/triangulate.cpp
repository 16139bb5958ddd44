#include "core/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/corner_tree.h"
#include "core/geometry/polygon_sweep.h"

namespace nacre {
namespace {

using Triangle = std::array<std::size_t, 3>;

// From the first corner, which loses the least digits, and of a size about 1.
std::vector<glm::dvec3> of_usual_size(std::span<const glm::dvec3> polygon) {
    std::vector<glm::dvec3> result;
    double largest = 0;
    for (const glm::dvec3& p : polygon) {
        const glm::dvec3 from_first = p - polygon[0], size = glm::abs(from_first);
        largest = std::max({largest, size.x, size.y, size.z});
        result.push_back(from_first);
    }
    if (!(largest > 0)) return result;
    // A power of 2, which rounds nothing.
    const int exponent = -std::ilogb(largest);
    for (glm::dvec3& p : result)
        p = {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent), std::scalbn(p.z, exponent)};
    return result;
}

// Twice the area seen from where it is largest; one that crosses itself may have none, then its widest corner
// decides.
glm::dvec3 normal_of(std::span<const glm::dvec3> polygon) {
    glm::dvec3 sum{0}, widest{0};
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const glm::dvec3 cross = glm::cross(polygon[i], polygon[i + 1]);
        sum += cross;
        if (glm::dot(cross, cross) > glm::dot(widest, widest)) widest = cross;
    }
    return glm::dot(sum, sum) > 1e-18 * glm::dot(widest, widest) ? sum : widest;
}

// Seen along the coordinate axis that is nearest to the normal: no coordinate is rounded.
std::vector<glm::dvec2> seen_along_axis(std::span<const glm::dvec3> polygon, glm::dvec3 normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& p : polygon)
        flat.push_back(normal[axis] >= 0 ? glm::dvec2(p[x], p[y]) : glm::dvec2(p[y], p[x]));
    return flat;
}

std::vector<glm::dvec2> seen_along_normal(std::span<const glm::dvec3> polygon, glm::dvec3 normal) {
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 aside = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 x = glm::normalize(glm::cross(aside, normal));
    const glm::dvec3 y = glm::normalize(glm::cross(normal, x));
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& p : polygon) flat.emplace_back(glm::dot(p, x), glm::dot(p, y));
    return flat;
}

// What a corner must fulfil to be cut off, less and less: the next one is asked of a corner only while none
// is known that fulfils the one before.
enum class Rule {
    ear,       // convex, and nothing of the polygon runs through its triangle
    touching,  // convex, with no corner inside its triangle, whatever lies on its edge
    convex,
    any
};
constexpr std::size_t rules = 4;

constexpr int touching_max = 64;  // corners on the edge of one triangle whose neighbours are looked at

// So many times n log n steps are spent on looking for ears.
constexpr double patience = 8;

class EarCutter {
  public:
    explicit EarCutter(std::vector<glm::dvec2> flat);
    EarCutter(const EarCutter&) = delete;
    EarCutter& operator=(const EarCutter&) = delete;

    // False where the polygon crosses itself as it is seen.
    bool cut();
    const std::vector<Triangle>& triangles() const { return triangles_; }
    std::size_t steps() const { return steps_ + in_the_way_.steps(); }

  private:
    struct Queue {
        std::vector<std::size_t> corners, entries;  // entries: see entry_
        std::size_t next = 0;
    };

    double turn_at(std::size_t i) const { return turn(flat_[before_[i]], flat_[i], flat_[after_[i]]); }
    bool encloses_nothing(std::size_t i) const;
    bool fulfils(std::size_t i, Rule rule);
    bool runs_through(std::size_t i, const std::array<glm::dvec2, 3>& triangle) const;
    void ask(std::size_t i, std::size_t rule);
    void look_again(std::size_t i);
    void cut_off(std::size_t i);
    bool sweep_rest();

    std::vector<glm::dvec2> flat_;
    std::vector<std::size_t> before_, after_;
    std::vector<std::size_t> entry_;  // the newest one of each corner, the only one that counts; 0: cut off
    std::array<Queue, rules> queues_;
    std::size_t entries_ = 0, left_;
    CornerTree in_the_way_;  // corners that are not convex
    std::vector<Triangle> triangles_;
    std::size_t steps_ = 0;
    bool patient_ = true;
};

EarCutter::EarCutter(std::vector<glm::dvec2> flat)
    : flat_(std::move(flat)),
      before_(flat_.size()),
      after_(flat_.size()),
      entry_(flat_.size()),
      left_(flat_.size()),
      in_the_way_(flat_) {
    const std::size_t n = flat_.size();
    for (std::size_t i = 0; i < n; ++i) {
        before_[i] = (i + n - 1) % n;
        after_[i] = (i + 1) % n;
    }
    // A quadrilateral is cut from its first corner to its third.
    for (std::size_t i = 1; i <= n; ++i) look_again(i % n);
}

// A corner in the place of a neighbour, or the tip of an edge that is gone both ways.
bool EarCutter::encloses_nothing(std::size_t i) const {
    return turn_at(i) == 0 && glm::dot(flat_[before_[i]] - flat_[i], flat_[after_[i]] - flat_[i]) >= 0;
}

// Whether the polygon enters the triangle at its corner i, which lies in it or on its edge. The last edge of
// the triangle is where it would be cut off.
bool EarCutter::runs_through(std::size_t i, const std::array<glm::dvec2, 3>& triangle) const {
    std::array<bool, 3> on{};
    for (std::size_t k = 0; k < 3; ++k) on[k] = turn(triangle[k], triangle[(k + 1) % 3], flat_[i]) == 0;
    if (!on[0] && !on[1]) return true;
    for (const std::size_t neighbour : {before_[i], after_[i]}) {
        bool inward = true;
        for (std::size_t k = 0; k < 3; ++k)
            inward = inward && (!on[k] || turn(triangle[k], triangle[(k + 1) % 3], flat_[neighbour]) > 0);
        if (inward) return true;
    }
    return false;
}

bool EarCutter::fulfils(std::size_t i, Rule rule) {
    ++steps_;
    if (rule == Rule::any) return true;
    if (rule == Rule::ear && encloses_nothing(i)) return true;
    if (!(turn_at(i) > 0)) return false;
    if (rule == Rule::convex) return true;
    if (!patient_) return false;
    const std::size_t a = before_[i], c = after_[i];
    const std::array<glm::dvec2, 3> triangle{flat_[a], flat_[i], flat_[c]};
    if (rule == Rule::touching) return !in_the_way_.any_in(triangle, false, [](std::size_t) { return true; });
    int touching = 0;
    return !in_the_way_.any_in(triangle, true, [&](std::size_t other) {
        return other != a && other != c && (runs_through(other, triangle) || ++touching > touching_max);
    });
}

void EarCutter::ask(std::size_t i, std::size_t rule) {
    entry_[i] = ++entries_;
    queues_[rule].corners.push_back(i);
    queues_[rule].entries.push_back(entries_);
}

// A corner whose neighbours are new. No other can have become an ear: of the corners that stand in its way
// the one farthest from the cut is not convex, so that it stays while the ear's neighbours do.
void EarCutter::look_again(std::size_t i) {
    in_the_way_.set(i, !(turn_at(i) > 0));
    ask(i, 0);
}

void EarCutter::cut_off(std::size_t i) {
    const std::size_t a = before_[i], c = after_[i];
    triangles_.push_back({a, i, c});
    after_[a] = c;
    before_[c] = a;
    entry_[i] = 0;
    in_the_way_.set(i, false);
    --left_;
    look_again(c);
    look_again(a);
}

// What is left of a polygon of many spikes. One that crosses itself is cut at any corner that is convex.
bool EarCutter::sweep_rest() {
    patient_ = false;
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < flat_.size(); ++i)
        if (entry_[i] != 0) corners.push_back(i);
    return sweep_polygon(flat_, corners, triangles_, steps_);
}

bool EarCutter::cut() {
    bool clean = true;
    const double n = static_cast<double>(flat_.size()), most_steps = patience * n * std::log2(n);
    while (left_ > 3) {
        if (patient_ && static_cast<double>(steps()) > most_steps && sweep_rest()) return clean;
        std::size_t rule = 0;
        while (queues_[rule].next == queues_[rule].corners.size()) ++rule;
        Queue& queue = queues_[rule];
        const std::size_t i = queue.corners[queue.next], entry = queue.entries[queue.next];
        ++queue.next;
        if (entry != entry_[i]) continue;
        if (!fulfils(i, static_cast<Rule>(rule))) {
            ask(i, rule + 1);
            continue;
        }
        clean = clean && rule < 2;
        cut_off(i);
    }
    std::size_t first = 0;
    while (entry_[first] == 0) ++first;
    triangles_.push_back({first, after_[first], after_[after_[first]]});
    return clean;
}

}  // namespace

std::vector<Triangle> triangulated(std::span<const glm::dvec3> polygon, std::size_t* steps) {
    if (polygon.size() < 3) return {};
    if (polygon.size() == 3) return {{0, 1, 2}};
    const std::vector<glm::dvec3> sized = of_usual_size(polygon);
    const glm::dvec3 normal = normal_of(sized);
    EarCutter along_axis(seen_along_axis(sized, normal));
    const bool clean = along_axis.cut();
    if (steps != nullptr) *steps += along_axis.steps();
    if (clean || !(glm::dot(normal, normal) > 0)) return along_axis.triangles();
    // One that is not flat may cross itself only as it is seen along the axis.
    EarCutter along_normal(seen_along_normal(sized, normal));
    along_normal.cut();
    if (steps != nullptr) *steps += along_normal.steps();
    return along_normal.triangles();
}

}  // namespace nacre
