#include "core/exchange/log_chart.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/exchange/log_axis.h"
#include "core/exchange/svg_page.h"

namespace nacre {
namespace {

constexpr double width = 1120, height = 660;                     // pixels
constexpr double left = 112, right = 806, top = 92, foot = 574;  // of the plot
constexpr double legend_left = 838;
constexpr std::size_t legend_characters = 40;  // on a line

// Okabe & Ito (2008), without yellow, which light grounds swallow.
constexpr std::array colours = {"#0072B2", "#E69F00", "#009E73", "#D55E00", "#1f2328", "#CC79A7", "#56B4E9"};

std::vector<std::string> wrapped(const std::string& text, std::size_t characters) {
    std::vector<std::string> lines = {""};
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > characters) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
        begin = end + 1;
    }
    return lines;
}

struct Box {
    double left, top, right, bottom;
    bool holds(double x, double y) const { return x >= left && x <= right && y >= top && y <= bottom; }
};

class Drawing {
  public:
    explicit Drawing(const LogChart& chart) : chart_(chart), page_({width, height}, chart.title) {
        std::vector<double> xs, ys;
        for (const ChartLine& line : chart.lines)
            for (const auto* points : {&line.points, &line.faint})
                for (const ChartPoint& point : *points) {
                    xs.push_back(point.x);
                    ys.push_back(std::min(kept(point.y), chart.y_most));
                }
        x_ = with_margin(range_of(xs));
        y_ = whole_decades(range_of(ys));
    }

    std::string text() && {
        page_.text({left, 40}, chart_.title, "font-size=\"24\" font-weight=\"600\"");
        page_.text({left, 66}, chart_.subtitle, "font-size=\"15\" fill=\"#5b636d\"");
        axes();
        for (std::size_t i = 0; i < chart_.lines.size(); ++i) draw_line(chart_.lines[i], i);
        labels();
        legend();
        return std::move(page_).finished();
    }

  private:
    double x_at(double value) const { return left + (right - left) * x_.place(value); }
    // Far above the plot no further than the clip needs; what is no number stands there too.
    double kept(double y) const {
        const double most = 1e3 * chart_.y_most;
        return y <= most ? std::max(y, chart_.y_least) : most;
    }
    double y_at(double value) const { return foot - (foot - top) * y_.place(kept(value)); }
    bool inside(const ChartPoint& point) const { return point.y <= chart_.y_most; }

    void grid_line(double x1, double y1, double x2, double y2, const char* colour) {
        page_.line({x1, y1}, {x2, y2}, fmt::format("stroke=\"{}\"", colour));
    }

    void axes() {
        for (int decade = x_.first_tick() - 1; decade <= x_.last_tick(); ++decade) {
            for (int i = 1; i < 10; ++i) {
                const double x = x_at(i * std::pow(10, decade));
                if (x < left - 0.5 || x > right + 0.5) continue;
                if (i > 1) {
                    grid_line(x, foot, x, foot - 4, svg_ink::quiet);
                    continue;
                }
                grid_line(x, top, x, foot, svg_ink::grid);
                page_.text({x, foot + 24}, tick_label(chart_.x.unit, decade), "text-anchor=\"middle\"");
            }
        }
        for (int decade = y_.first_tick(); decade <= y_.last_tick(); ++decade) {
            const double y = y_at(std::pow(10, decade));
            grid_line(left, y, right, y, svg_ink::grid);
            page_.text({left - 10, y + 5}, tick_label(chart_.y.unit, decade), "text-anchor=\"end\"");
            for (int i = 2; i < 10 && decade < y_.last_tick(); ++i) {
                const double minor = y_at(i * std::pow(10, decade));
                grid_line(left, minor, left + 4, minor, svg_ink::quiet);
            }
        }
        grid_line(left, foot, right, foot, svg_ink::quiet);
        grid_line(left, top, left, foot, svg_ink::quiet);
        page_.text({0.5 * (left + right), foot + 56}, chart_.x.title,
                   "text-anchor=\"middle\" font-size=\"15\"");
        page_.upward_text({28, 0.5 * (top + foot)}, chart_.y.title,
                          "text-anchor=\"middle\" font-size=\"15\"");
    }

    void path(const std::vector<ChartPoint>& points, const std::string& style) {
        std::vector<glm::dvec2> places;
        for (const ChartPoint& point : points) places.emplace_back(x_at(point.x), y_at(point.y));
        page_.path(places, style);
    }

    // A shape of its own for each line, about 11 pixels wide.
    void mark(std::size_t index, double x, double y) {
        static constexpr const char* shapes[] = {
            "M-5 0A5 5 0 1 0 5 0A5 5 0 1 0 -5 0Z",
            "M-4.6 -4.6H4.6V4.6H-4.6Z",
            "M0 -6.2L5.6 4.2H-5.6Z",
            "M0 -6.4L6.4 0L0 6.4L-6.4 0Z",
            "M0 -8L1.9 -2.6L7.6 -2.5L3.1 1L4.7 6.5L0 3.2L-4.7 6.5L-3.1 1L-7.6 -2.5L-1.9 -2.6Z",
            "M-5 -3.2L-3.2 -5L0 -1.8L3.2 -5L5 -3.2L1.8 0L5 3.2L3.2 5L0 1.8L-3.2 5L-5 3.2L-1.8 0Z",
            "M0 6.2L5.6 -4.2H-5.6Z"};
        page_.mark({x, y}, shapes[index % std::size(shapes)],
                   fmt::format("fill=\"{}\" stroke=\"#ffffff\"", colours[index % colours.size()]));
    }

    void draw_line(const ChartLine& line, std::size_t index) {
        const char* colour = colours[index % colours.size()];
        page_.begin_clip({left, top - 7}, {right - left + 8, foot - top + 14});
        if (line.joined) path(line.points, fmt::format("stroke=\"{}\" stroke-width=\"2.4\"", colour));
        path(line.faint, fmt::format("stroke=\"{}\" stroke-width=\"1.3\" stroke-dasharray=\"2 4\"", colour));
        page_.end_clip();
        for (const ChartPoint& point : line.points)
            if (inside(point)) mark(index, x_at(point.x), y_at(point.y));
    }

    // How much of the solid lines and marks a box would hide.
    int hidden_by(const Box& box) const {
        constexpr int steps = 64;
        int hidden = 0;
        for (const ChartLine& line : chart_.lines)
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                const double x = x_at(line.points[i].x), y = y_at(line.points[i].y);
                hidden += box.holds(x, y) ? 4 : 0;
                if (!line.joined || i == 0) continue;
                const double from_x = x_at(line.points[i - 1].x), from_y = y_at(line.points[i - 1].y);
                for (int s = 0; s < steps; ++s)
                    hidden += box.holds(std::lerp(from_x, x, s / double(steps)),
                                        std::lerp(from_y, y, s / double(steps)));
            }
        return hidden;
    }

    // Beside its mark where it hides the least, above all lines and with a white seam.
    void place_label(const ChartPoint& point) {
        const double x = x_at(point.x), y = y_at(point.y);
        const double length = 7.8 * static_cast<double>(point.label.size());
        struct Place {
            double x, y;
        };
        Place best{};
        int least = std::numeric_limits<int>::max();
        for (const Place at :
             {Place{x + 11, y - 8}, Place{x - 11 - length, y + 18}, Place{x + 11, y + 18},
              Place{x - 11 - length, y - 8}, Place{x - length / 2, y - 16}, Place{x - length / 2, y + 26},
              Place{x + 14, y + 5}, Place{x - 14 - length, y + 5}}) {
            const Box box{at.x - 3, at.y - 14, at.x + length + 3, at.y + 5};
            if (box.left < left || box.right > right || box.top < top || box.bottom > foot) continue;
            const int hidden = hidden_by(box);
            if (hidden >= least) continue;
            least = hidden;
            best = at;
        }
        if (least < std::numeric_limits<int>::max())
            page_.text({best.x, best.y}, point.label,
                       "font-weight=\"600\" stroke=\"#ffffff\" stroke-width=\"4\" stroke-linejoin=\"round\" "
                       "paint-order=\"stroke\"");
    }

    void labels() {
        for (const ChartLine& line : chart_.lines)
            for (const ChartPoint& point : line.points)
                if (!point.label.empty() && inside(point)) place_label(point);
    }

    void legend() {
        double y = top + 6;
        for (std::size_t i = 0; i < chart_.lines.size(); ++i) {
            const ChartLine& line = chart_.lines[i];
            if (line.joined && line.points.size() > 1)
                grid_line_of(legend_left, y, colours[i % colours.size()]);
            if (!line.points.empty()) mark(i, legend_left + 13, y);
            page_.text({legend_left + 36, y + 5}, line.name, "font-weight=\"600\"");
            y += 6;
            for (const std::string& row : wrapped(line.note, legend_characters))
                page_.text({legend_left + 36, y += 17}, row, "font-size=\"12\" fill=\"#5b636d\"");
            y += 27;
        }
        y += 4;
        for (const std::string& note : chart_.notes) {
            for (const std::string& row : wrapped(note, legend_characters + 4))
                page_.text({legend_left, y += 17}, row, "font-size=\"12\" fill=\"#5b636d\"");
            y += 8;
        }
    }

    void grid_line_of(double x, double y, const char* colour) {
        page_.line({x, y}, {x + 26, y}, fmt::format("stroke=\"{}\" stroke-width=\"2.4\"", colour));
    }

    const LogChart& chart_;
    LogRange x_, y_;
    SvgPage page_;
};

}  // namespace

std::string svg_chart(const LogChart& chart) { return Drawing(chart).text(); }

}  // namespace nacre
