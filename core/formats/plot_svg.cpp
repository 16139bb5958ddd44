#include <fmt/core.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/file_extension.h"
#include "core/base/system/atomic_file.h"
#include "core/base/utf8.h"
#include "core/formats/plot_files.h"
#include "core/formats/svg_page.h"

namespace nacre {
namespace {

constexpr glm::dvec2 page_size(1000, 620);
constexpr PlotBox plot_box{{36, 24}, {964, 596}};
constexpr double text_size = 16;
constexpr double character_ems = 0.55;  // of a usual face, on the average

// On white. The azimuths': Okabe & Ito (2008), told apart by colour-blind readers.
const char* colour_of(Ink ink) {
    switch (ink) {
        case Ink::text:
        case Ink::plain:
            return svg_ink::text;
        case Ink::quiet:
            return svg_ink::quiet;
        case Ink::grid:
            return svg_ink::grid;
        case Ink::red:
            return "#cc3311";
        case Ink::green:
            return "#228833";
        case Ink::blue:
            return "#2255aa";
        case Ink::first:
            return "#0072B2";
        case Ink::second:
            return "#E69F00";
        case Ink::third:
            return "#009E73";
        case Ink::fourth:
            return "#CC79A7";
    }
    return svg_ink::text;
}

std::string colour_text(const glm::dvec3& c) {
    const glm::ivec3 bytes(glm::round(c));
    return fmt::format("#{:02x}{:02x}{:02x}", bytes.x, bytes.y, bytes.z);
}

class SvgPen final : public PlotPen {
  public:
    explicit SvgPen(SvgPage& page) : page_(page) {}

    double em() const override { return text_size; }

    double text_width(const std::string& text) const override {
        return character_ems * text_size * static_cast<double>(code_points(text).size());
    }

    void text(glm::dvec2 left_middle, const std::string& text, Ink ink) override {
        page_.text(left_middle + glm::dvec2(0, 0.36 * text_size), text,
                   fmt::format("font-size=\"{}\" fill=\"{}\"", text_size, colour_of(ink)));
    }

    void line(std::span<const glm::dvec2> points, Ink ink, double width) override {
        page_.path(points, fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\"", colour_of(ink), width));
    }

    void disc(glm::dvec2 middle, double radius, Ink ink) override {
        page_.circle(middle, radius, fmt::format("fill=\"{}\"", colour_of(ink)));
    }

    // A cell has one colour here; a seam of its own colour closes the gaps between neighbours.
    void mesh(std::span<const glm::dvec2> corners, std::span<const glm::u8vec3> colours,
              std::span<const Cell> cells) override {
        for (const Cell& cell : cells) {
            std::array<glm::dvec2, 4> points{};
            glm::dvec3 colour(0);
            for (std::size_t i = 0; i < 4; ++i) {
                points[i] = corners[cell[i]];
                colour += glm::dvec3(colours[cell[i]]) / 4.0;
            }
            const std::string text = colour_text(colour);
            page_.polygon(points, fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.5\"", text));
        }
    }

    // Neighbours of one colour in a row become one rectangle.
    void picture(const PlotBox& box, const SlicePlot& slice) override {
        const PlotPixels pixels = slice_pixels(slice);
        const glm::dvec2 step = box.size() / glm::dvec2(pixels.size - 1);
        const auto edge = [&](int i, int axis) {
            return std::clamp(box.low[axis] + (i - 0.5) * step[axis], box.low[axis], box.high[axis]);
        };
        for (int row = 0; row < pixels.size.y; ++row)
            for (int begin = 0, end = 0; begin < pixels.size.x; begin = end) {
                const glm::u8vec3& colour =
                    pixels.colours[static_cast<std::size_t>(row * pixels.size.x + begin)];
                while (end < pixels.size.x &&
                       pixels.colours[static_cast<std::size_t>(row * pixels.size.x + end)] == colour)
                    ++end;
                // Half a pixel into the next one, so that no gap shows between them.
                const glm::dvec2 low(edge(begin, 0), edge(row, 1)),
                    high = glm::min(glm::dvec2(edge(end, 0), edge(row + 1, 1)) + 0.5, box.high);
                page_.rectangle(low, high - low,
                                fmt::format("fill=\"{}\" shape-rendering=\"crispEdges\"",
                                            colour_text(glm::dvec3(colour))));
            }
    }

  private:
    SvgPage& page_;
};

}  // namespace

std::string plot_svg(const Plot& plot, const ShapeView& view) {
    SvgPage page(page_size, plot.title);
    SvgPen pen(page);
    draw_plot(pen, plot, layout_plot(plot, plot_box, pen), view, {});
    return std::move(page).finished();
}

std::string plot_svg(const PointPlot& plot) {
    constexpr glm::dvec2 size(1200, 680);
    constexpr glm::dvec2 margin(36, 24);
    SvgPage page(size, plot.title);
    SvgPen pen(page);
    draw_point_plot(pen, plot, {margin, size - margin});
    return std::move(page).finished();
}

void check_plot_file(const std::filesystem::path& file) {
    const std::string extension = extension_of(file);
    if (extension != ".svg" && extension != ".csv")
        throw UserError(file.string(), "write", "a plot is a .svg or a .csv file");
}

std::string plot_text(const std::filesystem::path& file, const Plot& plot, const ShapeView& view) {
    check_plot_file(file);
    return extension_of(file) == ".svg" ? plot_svg(plot, view) : plot_csv(plot);
}

void write_plot(const std::filesystem::path& file, const Plot& plot, const ShapeView& view) {
    write_file_atomically(file, plot_text(file, plot, view));
}

}  // namespace nacre
