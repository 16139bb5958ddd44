// A page of an SVG file, drawn from the back to the front.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>

namespace nacre {

// Colours on the white ground of a page.
namespace svg_ink {
inline constexpr const char* text = "#1f2328";
inline constexpr const char* quiet = "#5b636d";
inline constexpr const char* grid = "#e3e6ea";
}  // namespace svg_ink

// Places in pixels from the left top. `style` is attributes as SVG has them; texts are escaped. The finished
// text is well-formed XML in UTF-8.
class SvgPage {
  public:
    SvgPage(glm::dvec2 size, const std::string& title);

    void text(glm::dvec2 at, const std::string& text, const std::string& style = {});
    void path(std::span<const glm::dvec2> points, const std::string& style);     // nothing for a single one
    void polygon(std::span<const glm::dvec2> points, const std::string& style);  // closed
    void rectangle(glm::dvec2 low, glm::dvec2 size, const std::string& style);
    void circle(glm::dvec2 middle, double radius, const std::string& style);

    std::string finished() &&;

  private:
    std::string svg_;
};

}  // namespace nacre
