#include "core/plot/point_plot.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

#include "core/plot/draw_parts.h"

namespace nacre {
namespace {

using Line = std::vector<glm::dvec2>;

constexpr double legend_part = 0.29;  // of the box's width
constexpr double head_ems = 5;        // height of the title, the subtitle and the title of y
constexpr double row_ems = 1.24;      // of a legend
constexpr double swatch_ems = 1.9;    // its line

std::vector<std::string> wrapped(const PlotPen& pen, const std::string& text, double width) {
    std::vector<std::string> rows = {""};
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        const std::string row = rows.back().empty() ? word : rows.back() + " " + word;
        if (!rows.back().empty() && pen.text_width(row) > width)
            rows.push_back(word);
        else
            rows.back() = row;
        begin = end + 1;
    }
    return rows;
}

// A polygon or a star: every second of its corners, if `inner` < 1, lies within.
struct MarkShape {
    int corners;
    double inner;
    double turn;  // of its first corner, parts of a turn from the top
};
constexpr MarkShape mark_shapes[] = {{24, 1, 0},   {4, 1, 0.125}, {3, 1, 0},  {4, 1, 0},
                                     {10, 0.4, 0}, {8, 0.3, 0},   {3, 1, 0.5}};

class Drawing {
  public:
    Drawing(PlotPen& pen, const PointPlot& plot, const PlotBox& box) : pen_(pen), plot_(plot), box_(box) {
        const double em = pen.em();
        PlotBox rest{{box.low.x, box.low.y + head_ems * em}, box.high};
        rest.high.x -= legend_part * box.size().x + 1.4 * em;
        area_ = inside_axes(rest, plot.y, pen);
        legend_ = {{rest.high.x + 1.4 * em, area_.low.y}, {box.high.x, area_.high.y}};
        for (const PointSeries& one : plot.series)
            if (one.joined)
                for (Line& line : lines_of(one.points)) thick_.push_back(std::move(line));
    }

    void draw() {
        const double em = pen_.em();
        pen_.text(box_.low + glm::dvec2(0, 0.6 * em), plot_.title, Ink::text);
        pen_.text(box_.low + glm::dvec2(0, 1.9 * em), plot_.subtitle, Ink::quiet);
        pen_.text({box_.low.x, area_.low.y - 1.4 * em}, plot_.y.title, Ink::quiet);
        draw_axes(pen_, area_, plot_.x, plot_.y);
        for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(i);
        for (const PointSeries& one : plot_.series)
            for (std::size_t i = 0; i < one.labels.size(); ++i)
                if (inside(one.points[i])) draw_label(place(one.points[i]), one.labels[i]);
        draw_legend_and_notes();
    }

  private:
    bool inside(glm::dvec2 point) const { return point.y <= plot_.y.high; }

    glm::dvec2 place(glm::dvec2 point) const {
        return {std::lerp(area_.low.x, area_.high.x, plot_.x.place(point.x)),
                std::lerp(area_.high.y, area_.low.y, plot_.y.place(point.y))};
    }

    // In pixels, cut where it leaves the top.
    std::vector<Line> lines_of(const Line& points) const {
        const double top = plot_.y.high;
        std::vector<Line> lines(1);
        glm::dvec2 before(0);
        for (glm::dvec2 point : points) {
            point.y = point.y <= 1e3 * top ? std::max(point.y, plot_.y.low) : 1e3 * top;
            if (before.x > 0 && inside(point) != inside(before)) {
                const double part = std::log(top / before.y) / std::log(point.y / before.y);
                lines.back().push_back(place({before.x * std::pow(point.x / before.x, part), top}));
                if (inside(before)) lines.emplace_back();
            }
            if (inside(point)) lines.back().push_back(place(point));
            before = point;
        }
        return lines;
    }

    void draw_mark(std::size_t index, glm::dvec2 middle) {
        const MarkShape& shape = mark_shapes[index % std::size(mark_shapes)];
        Line outline;
        for (int i = 0; i <= shape.corners + 1; ++i) {  // one more, so that the first corner is joined
            const double angle = 2 * std::numbers::pi * (static_cast<double>(i) / shape.corners + shape.turn);
            const double radius = 0.36 * pen_.em() * (i % 2 == 1 ? shape.inner : 1);
            outline.push_back(middle + radius * glm::dvec2(std::sin(angle), -std::cos(angle)));
        }
        pen_.line(outline, plot_.series[index].ink, 0.16 * pen_.em());
    }

    void draw_series(std::size_t index) {
        const PointSeries& one = plot_.series[index];
        for (const Line& line : lines_of(one.thin_points))
            if (line.size() > 1) pen_.line(line, one.ink, hair(pen_));
        for (const Line& line : one.joined ? lines_of(one.points) : std::vector<Line>())
            stroked(pen_, line, {.name = one.name, .ink = one.ink});
        for (const glm::dvec2& point : one.points)
            if (inside(point)) draw_mark(index, place(point));
    }

    // How much of the thick lines and of the marks without lines a box would hide.
    int hidden_by(const PlotBox& box) const {
        constexpr int steps = 64;
        int hidden = 0;
        for (const Line& line : thick_)
            for (std::size_t i = 1; i < line.size(); ++i)
                for (int s = 0; s <= steps; ++s)
                    hidden += box.holds(glm::mix(line[i - 1], line[i], s / double(steps)));
        for (const PointSeries& one : plot_.series)
            for (const glm::dvec2& point : one.points) hidden += box.holds(place(point)) ? 4 : 0;
        return hidden;
    }

    // Beside its mark where it hides the least.
    void draw_label(glm::dvec2 mark, const std::string& label) {
        const double em = pen_.em(), width = pen_.text_width(label);
        const glm::dvec2 room = em * glm::dvec2(0.3, 0.8);  // around the text, for marks
        int least = std::numeric_limits<int>::max();
        glm::dvec2 best(0);
        for (const double side : {0.7 * em, -0.7 * em - width, -0.5 * width})
            for (const double drop : {-0.9 * em, 0.9 * em, 0.0}) {
                const glm::dvec2 at = mark + glm::dvec2(side, drop);
                const PlotBox box{at - room, at + room + glm::dvec2(width, 0)};
                if (!area_.holds(box.low) || !area_.holds(box.high)) continue;
                const int hidden = hidden_by(box);
                if (hidden < least) least = hidden, best = at;
            }
        if (least < std::numeric_limits<int>::max()) pen_.text(best, label, Ink::text);
    }

    void draw_paragraph(glm::dvec2& at, const std::string& text, Ink ink) {
        for (const std::string& row : wrapped(pen_, text, legend_.high.x - at.x)) {
            pen_.text(at, row, ink);
            at.y += row_ems * pen_.em();
        }
    }

    void draw_legend_and_notes() {
        const double em = pen_.em(), swatch = swatch_ems * em;
        glm::dvec2 at = legend_.low + glm::dvec2(swatch + 0.6 * em, 0);
        for (std::size_t i = 0; i < plot_.series.size(); ++i) {
            const PointSeries& one = plot_.series[i];
            const Line line = {{legend_.low.x, at.y}, {legend_.low.x + swatch, at.y}};
            if (one.joined && one.points.size() > 1) stroked(pen_, line, {.name = "", .ink = one.ink});
            if (!one.points.empty()) draw_mark(i, 0.5 * (line[0] + line[1]));
            draw_paragraph(at, one.name, Ink::text);
            if (!one.note.empty()) draw_paragraph(at, one.note, Ink::quiet);
            at.y += 0.4 * em;
        }
        at.x = legend_.low.x;
        for (const std::string& note : plot_.notes) {
            at.y += 0.4 * em;
            draw_paragraph(at, note, Ink::quiet);
        }
    }

    PlotPen& pen_;
    const PointPlot& plot_;
    PlotBox box_, area_, legend_;
    std::vector<Line> thick_;  // of all series
};

}  // namespace

void fit_axes(PointPlot& plot, double y_min, double y_max) {
    glm::dvec2 low(std::numeric_limits<double>::max()), high(-low);  // decades
    for (const PointSeries& one : plot.series)
        for (const Line* line : {&one.points, &one.thin_points})
            for (const glm::dvec2& point : *line) {
                const double y = point.y <= y_max ? std::max(point.y, y_min) : y_max;
                const glm::dvec2 decades(std::log10(point.x), std::log10(y));
                low = glm::min(low, decades);
                high = glm::max(high, decades);
            }
    if (low.x > high.x) low = high = glm::dvec2(0);
    const double margin = std::max(0.04 * (high.x - low.x), 0.5 * (1 - high.x + low.x));
    plot.x.low = std::pow(10, low.x - margin);
    plot.x.high = std::pow(10, high.x + margin);
    const double foot = std::floor(low.y + 1e-9);
    plot.y.low = std::pow(10, foot);
    plot.y.high = std::pow(10, std::max(foot + 1, std::ceil(high.y - 1e-9)));
    plot.x.logarithmic = plot.y.logarithmic = true;
}

void draw_point_plot(PlotPen& pen, const PointPlot& plot, const PlotBox& box) {
    Drawing(pen, plot, box).draw();
}

}  // namespace nacre
