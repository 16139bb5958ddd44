// The interface that plots are drawn through, to the window or to a file.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/plot/plot.h"

namespace nacre {

// Pixels, from the left top.
struct PlotBox {
    glm::dvec2 low, high;

    glm::dvec2 size() const { return high - low; }
    bool holds(glm::dvec2 at) const {
        return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
    }
};

// 8-bit sRGB, rows from the top.
struct PlotPixels {
    glm::ivec2 size{0};
    std::vector<glm::u8vec3> colours;
};

class PlotPen {
  public:
    virtual ~PlotPen() = default;

    virtual double em() const = 0;  // height of the text
    virtual double text_width(const std::string& text) const = 0;
    virtual void text(glm::dvec2 left_middle, const std::string& text, Ink ink) = 0;
    virtual void line(std::span<const glm::dvec2> points, Ink ink, double width) = 0;
    virtual void disc(glm::dvec2 middle, double radius, Ink ink) = 0;

    // Four-cornered cells in the order in which they hide each other; a colour for each corner.
    using Cell = std::array<std::uint16_t, 4>;
    virtual void mesh(std::span<const glm::dvec2> corners, std::span<const glm::u8vec3> colours,
                      std::span<const Cell> cells) = 0;

    // slice_pixels(), the middles of the outermost ones on the box's border.
    virtual void picture(const PlotBox& box, const SlicePlot& slice) = 0;
};

}  // namespace nacre
