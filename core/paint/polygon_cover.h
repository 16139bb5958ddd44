// How much of each pixel a polygon covers.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace nacre {

// Where the outline goes around a place twice the same way, the place is inside.
class PolygonCover {
  public:
    // Corners in pixels; the last is joined to the first.
    explicit PolygonCover(std::span<const glm::dvec2> outline);

    // Bilinear between the middles of pixels, 0 to 1.
    double operator()(glm::dvec2 at) const;

  private:
    void add_span(int row, double from, double to, float weight);
    float pixel(int column, int row) const;

    glm::ivec2 low_{0}, size_{0};  // the pixels that it touches
    std::vector<float> amounts_;
};

}  // namespace nacre
