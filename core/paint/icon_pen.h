// What a tool's sign is drawn with: a unit square, y downward.
#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace nacre {

class IconPen {
  public:
    virtual ~IconPen() = default;
    virtual void line(std::span<const glm::vec2> points, bool closed) const = 0;
    virtual void fill(std::span<const glm::vec2> convex) const = 0;
    virtual void circle(glm::vec2 middle, float radius) const = 0;
    virtual void disc(glm::vec2 middle, float radius) const = 0;

    void line(std::initializer_list<glm::vec2> points, bool closed = false) const {
        line(std::span(points.begin(), points.size()), closed);
    }
    void fill(std::initializer_list<glm::vec2> convex) const {
        fill(std::span(convex.begin(), convex.size()));
    }
};

}  // namespace nacre
