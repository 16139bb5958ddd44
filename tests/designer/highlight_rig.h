// The designer, and where on the sphere it made light.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/designer/rig.h"

namespace nacre::test {

// The sphere under a light from the viewer, so that the highlight's middle is the sphere's.
struct HighlightRig : Rig {
    HighlightRig() : Rig(2) { designer().scene.light.theta = 0; }

    // Draws the preview to the end and keeps it.
    void look() {
        play("move 5 5\nwait");
        REQUIRE(designer().baker.problem().empty());
        const Scene scene = designer().scene;
        picture_ = designer().preview.picture(scene, {side, side}, true);
        unit_ = pixels_per_unit(scene, {side, side});
    }

    // Linear radiance where facets shine that are tilted by half as much: x right and y up, degrees of the
    // highlight.
    glm::dvec3 colour(double x, double y) const {
        const double off = std::hypot(x, y) * std::numbers::pi / 180;
        const glm::dvec2 way = off > 0 ? glm::normalize(glm::dvec2(x, y)) : glm::dvec2(0);
        const glm::dvec2 at = 0.5 * side + unit_ * std::sin(off) * glm::dvec2(way.x, -way.y);
        const auto index = static_cast<std::size_t>(int(at.y) * side + int(at.x)) * 3;
        return {picture_.rgb.at(index), picture_.rgb.at(index + 1), picture_.rgb.at(index + 2)};
    }
    double shines(double x, double y) const { return colour(x, y).y; }

  private:
    static constexpr int side = 400;
    RenderedImage picture_;
    double unit_ = 1;
};

}  // namespace nacre::test
