// Gauss's rule over parts of the equal-area disk, to its rim.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/model/disk.h"
#include "core/model/lobe.h"
#include "core/model/quadrature.h"

namespace nacre {

// A rectangle on the disk's plane.
struct Box {
    dvec2 low, high;
};

// Over larger ones h and the rim bend too much for the rules below.
inline constexpr double largest_box = 1.0 / 60;

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

// The middle of a texel along one axis, in [-1, 1].
inline double middle_of(int side, int index) { return (2.0 * index + 1 - side) / side; }

// [low, high] cut at the middles of a picture's texels, of which there are none with a side of 0, and at 0,
// where quadrants meet.
std::vector<double> cuts_between(double low, double high, int side);

// Places all over the disk with their shares of solid angle, at which a smooth function times a picture of so
// many texels a side is integrated, or times two such pictures; 0 where there is no second.
void visit_disk(int side, int other_side, const std::function<void(dvec2 at, double solid_angle)>& visit);

}  // namespace nacre
