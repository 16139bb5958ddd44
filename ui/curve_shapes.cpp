#include "ui/curve_shapes.h"

#include <array>
#include <cmath>

namespace nacre::ui {
namespace {

// A Gaussian core and an exponential haze, close together where they bend.
CurvePoints core_and_haze() {
    constexpr double core = 1.6, haze = 10;  // degrees at which each has fallen to 1/e
    constexpr double share = 0.02;           // of the haze in the middle
    CurvePoints points;
    for (const double angle :
         {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 6.0, 9.0, 13.0, 18.0, 24.0, 32.0, 42.0, 56.0, 75.0}) {
        const double value =
            (1 - share) * std::exp(-angle * angle / (core * core)) + share * std::exp(-angle / haze);
        points.emplace_back(angle, three_digits(value));
    }
    points.emplace_back(90, 0);
    return points;
}

}  // namespace

std::span<const CurveShape> curve_shapes() {
    static const std::array<CurveShape, 3> shapes = {
        CurveShape{"Core and haze",
                   "A sharp core in a haze that fades over four decades: polished metal that was handled, "
                   "lacquer with fine dust.",
                   core_and_haze()},
        CurveShape{
            "Flat top",
            "As many facets at each angle up to a soft edge: a highlight that is evenly bright, like a "
            "disc.",
            {{0, 1}, {18, 1}, {20, 0.85}, {22, 0.4}, {24, 0.08}, {26, 0}}},
        CurveShape{"Halo",
                   "A faint core and a ring about it, sharper inside than outside, as ice crystals draw it "
                   "around the sun.",
                   {{0, 0.3},
                    {2, 0.1},
                    {5, 0.01},
                    {17, 0.01},
                    {20, 0.15},
                    {22, 1},
                    {23, 0.6},
                    {26, 0.12},
                    {32, 0.015},
                    {50, 0.001},
                    {70, 0}}}};
    return shapes;
}

}  // namespace nacre::ui
