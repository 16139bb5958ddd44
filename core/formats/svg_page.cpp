#include "core/formats/svg_page.h"

#include <fmt/core.h>

#include <utility>

#include "core/base/xml_text.h"

namespace nacre {
namespace {

constexpr const char* fonts = "Inter, 'Helvetica Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif";

std::string outline(std::span<const glm::dvec2> points) {
    std::string d;
    for (const glm::dvec2& point : points)
        d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", point.x, point.y);
    return d;
}

}  // namespace

SvgPage::SvgPage(glm::dvec2 size, const std::string& title) {
    svg_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"{2}\" font-size=\"14\" fill=\"{3}\">\n<title>{4}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        size.x, size.y, fonts, svg_ink::text, xml_text(title));
}

void SvgPage::text(glm::dvec2 at, const std::string& text, const std::string& style) {
    svg_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x, at.y, style, xml_text(text));
}

void SvgPage::path(std::span<const glm::dvec2> points, const std::string& style) {
    if (points.size() < 2) return;
    svg_ +=
        fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", outline(points), style);
}

void SvgPage::polygon(std::span<const glm::dvec2> points, const std::string& style) {
    svg_ += fmt::format("<path d=\"{}Z\" {}/>\n", outline(points), style);
}

void SvgPage::rectangle(glm::dvec2 low, glm::dvec2 size, const std::string& style) {
    svg_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", low.x,
                        low.y, size.x, size.y, style);
}

void SvgPage::circle(glm::dvec2 middle, double radius, const std::string& style) {
    svg_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", middle.x, middle.y, radius,
                        style);
}

std::string SvgPage::finished() && { return std::move(svg_) + "</svg>\n"; }

}  // namespace nacre
