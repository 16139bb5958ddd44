// What a plot says in a file and under the pointer.
#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "core/formats/plot_files.h"
#include "tests/core/plots.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"
#include "tests/core/well_formed.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
    return parts;
}

double number_of(const std::string& text) {
    double value = NAN;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

TEST_SUITE_BEGIN("plot");

TEST_CASE("a file holds every number of the plot, and is one of the two formats or none") {
    const auto tables = baked(two_sided());
    const CurvePlot plot = curves_of(*tables, settings_of(PlotKind::density));
    const std::vector<std::string> lines =
        split(plot_csv(*make_plot(*tables, settings_of(PlotKind::density))), '\n');
    REQUIRE(lines.size() == plot.at.size() + 1);
    for (std::size_t i = 0; i < plot.at.size(); ++i) {
        const std::vector<std::string> fields = split(lines[i + 1], ',');
        REQUIRE(fields.size() == plot.series.size() + 1);
        CHECK(number_of(fields[0]) == plot.at[i]);
        for (std::size_t s = 0; s < plot.series.size(); ++s)
            CHECK(number_of(fields[s + 1]) == plot.series[s].values[i]);
    }
    PlotSettings settings = settings_of(PlotKind::slice);
    settings.slice_side = 5;
    CHECK(split(plot_csv(*make_plot(*tables, settings)), '\n').size() == 26);

    const TemporaryFolder folder;
    write_plot(folder / "a.svg", *make_plot(*tables, settings));
    CHECK(folder.size() == 1);
    const Plot slice = *make_plot(*tables, settings);
    CHECK(user_error_of([&] { write_plot(folder / "a.pdf", slice); }).find("a .svg or a .csv") !=
          std::string::npos);
    CHECK(folder.size() == 1);
}

TEST_CASE("what stands under the pointer is what the plot holds there") {
    class Ruler final : public PlotPen {
      public:
        double em() const override { return 13; }
        double text_width(const std::string& text) const override { return 7 * double(text.size()); }
        void text(glm::dvec2, const std::string&, Ink) override { ++texts; }
        void line(std::span<const glm::dvec2>, Ink, double) override {}
        void disc(glm::dvec2, double, Ink) override {}
        void mesh(std::span<const glm::dvec2>, std::span<const glm::u8vec3>, std::span<const Cell>) override {
        }
        void picture(const PlotBox&, const SlicePlot&) override {}
        int texts = 0;
    } pen;
    const auto tables = baked(coloured(two_sided()));
    const PlotBox box{{10, 20}, {700, 260}};
    for (const PlotKind kind : plot_kinds) {
        const Plot plot = *make_plot(*tables, settings_of(kind));
        const PlotLayout layout = layout_plot(plot, box, pen);
        CAPTURE(name_of(kind));
        CHECK(box.holds(layout.area.low));
        CHECK(box.holds(layout.area.high));
        CHECK(box.holds(layout.legend.high));
        CHECK(layout.legend.low.x >= layout.area.high.x);
        CHECK(!read_plot(plot, layout, {}, box.low));
        const int before = pen.texts;
        draw_plot(pen, plot, layout, {}, {});
        CHECK(pen.texts > before + 4);
    }
    const Plot plot = *make_plot(*tables, settings_of(PlotKind::masking));
    const PlotLayout layout = layout_plot(plot, box, pen);
    const glm::dvec2 third = layout.area.low + layout.area.size() * glm::dvec2(1 / 3.0, 0.5);
    const auto reading = read_plot(plot, layout, {}, third);
    REQUIRE(reading);
    CHECK(reading->at.x == doctest::Approx(30));
    CHECK(reading->values[1] == std::get<CurvePlot>(plot.contents).value(1, reading->at.x));
    const Plot slice = *make_plot(*tables, settings_of(PlotKind::slice));
    const PlotLayout square = layout_plot(slice, box, pen);
    const auto corner = read_plot(slice, square, {}, {square.area.low.x, square.area.high.y});
    REQUIRE(corner);
    CHECK(corner->values[0] == std::get<SlicePlot>(slice.contents).values[0].x);
}

TEST_SUITE_END();
