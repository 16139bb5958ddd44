// The report of error beside time: what omissions cost, and its files.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/bake/bake.h"
#include "core/base/csv_field.h"
#include "core/base/xml_text.h"
#include "core/formats/plot_files.h"
#include "core/study/accuracy.h"
#include "core/study/accuracy_chart.h"
#include "core/study/accuracy_text.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/well_formed.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design brushed() { return design_of(GgxLobe{0.15, 0.6}); }

// A report that costs little.
DesignAccuracy small_report(Design design) {
    DesignAccuracy accuracy =
        measure_accuracy(design, {.area_probes = 20, .albedo_probes = 2, .longest = 1e-3});
    accuracy.file = "stem";
    return accuracy;
}

}  // namespace

TEST_SUITE_BEGIN("report");

TEST_CASE("each omission costs what it brings, and all of them together the most") {
    Design design = design_of(GgxLobe{0.3, 0.3});
    design.fresnel = SchlickFresnel{};
    const OmissionCosts costs = measure_omissions(design, {});
    CHECK(costs.omissions.size() == 3);
    for (const OmissionCost& cost : costs.omissions) {
        CAPTURE(cost.omission.what);
        CHECK(cost.with_it.bytes >= 2 * costs.bake.bytes);
        CHECK(cost.with_it.seconds > costs.bake.seconds);
        CHECK(cost.with_it.bytes <= costs.with_all.bytes);
    }
}

TEST_CASE("a bake uses no more symmetry than it is told, and never more than p has") {
    const Design design = brushed();
    const auto plain = bake(design), whole = bake(design, {.symmetry = Symmetry::none});
    CHECK(plain->needs.symmetry.symmetry == Symmetry::quarter);
    CHECK(whole->needs.symmetry.symmetry == Symmetry::none);
    CHECK(bake(design, {.symmetry = Symmetry::isotropic})->data == plain->data);
    const dvec3 k = polar(0.2, 4);
    const double g = plain->distribution->area(k).g;
    CHECK(std::fabs(whole->shading.projected_area(k, whole->shading.table_spot(k)) / g - 1) < 1e-3);
}

TEST_CASE("the report's files are whole: CSV rows, JSON and XML") {
    Design design = brushed();
    design.name = "A <wild> & \"quoted\", \xEF\xBF\xBF name\n";
    std::vector<DesignAccuracy> reports(2, small_report(design));
    MethodAccuracy& harmonics = reports[1].methods.back();
    REQUIRE(harmonics.kind == MethodKind::harmonics);
    harmonics.points.clear();
    harmonics.left_out = "p is too narrow";
    std::size_t points = 0;
    for (const DesignAccuracy& report : reports)
        for (const MethodAccuracy& method : report.methods) points += method.points.size();
    REQUIRE(points > 20);

    const std::string csv = accuracy_csv(reports);
    std::size_t rows = 0;
    bool quoted = false;
    for (const char c : csv) {
        if (c == '"') quoted = !quoted;
        rows += c == '\n' && !quoted ? 1 : 0;
    }
    CHECK(rows == 1 + points);
    CHECK(csv.find("\"A <wild> & \"\"quoted\"\", ") != std::string::npos);

    const auto json = nlohmann::json::parse(accuracy_json(reports));
    CHECK(json.at("designs").size() == 2);
    std::size_t json_points = 0;
    for (const auto& report : json.at("designs"))
        for (const auto& method : report.at("ways")) {
            json_points += method.at("points").size();
            for (const auto& point : method.at("points")) {
                CHECK(point.at("seconds").get<double>() > 0);
                CHECK(point.at("worst").get<double>() >= point.at("rms").get<double>());
            }
        }
    CHECK(json_points == points);
    CHECK(json.at("designs").at(1).at("ways").at(5).at("left_out") == "p is too narrow");

    for (const DesignAccuracy& report : reports)
        for (const ChartOf quantity : {ChartOf::area, ChartOf::albedo})
            CHECK(is_well_formed(plot_svg(accuracy_chart(report, quantity))));
    CHECK(chart_file(reports[0].file, ChartOf::albedo) == "stem-R.svg");
    const std::string markdown = accuracy_markdown(reports);
    for (const char* part :
         {"## Summary", "A \\<wild\\> \\& ", "stem-g.svg", "left out:", "with all of these"})
        CHECK_MESSAGE(markdown.find(part) != std::string::npos, part);
}

TEST_CASE("a name is text in a spreadsheet and in Markdown, whatever it begins with or holds") {
    CHECK(csv_field("plain") == "plain");
    CHECK(csv_field("a,b") == "\"a,b\"");
    for (const std::string text : {"=1+1", "+1", "-1", "@SUM(A1)", "\tx", "\rx"})
        CHECK(csv_field(text) == "\"'" + text + "\"");
    CHECK(csv_field("=\"x\"") == "\"'=\"\"x\"\"\"");

    DesignAccuracy report = small_report(brushed());
    report.name = "=cmd|'/c calc'!A1 # ~~x~~ $y$";
    report.file = "a>b (c)<d\\";
    CHECK(accuracy_csv({report}).find("\r\n\"'=cmd|'/c calc'!A1") != std::string::npos);
    const std::string markdown = accuracy_markdown({report});
    CHECK(markdown.find("=cmd\\|'/c calc'\\!A1 \\# \\~\\~x\\~\\~ \\$y\\$") != std::string::npos);
    CHECK(markdown.find("![g](<a\\>b (c)\\<d\\\\-g.svg>)") != std::string::npos);
}

TEST_CASE("a chart of nothing, of one point and of absurd ones is still XML") {
    PointPlot chart;
    chart.title = "<&>";
    const auto svg = [&] {
        fit_axes(chart, 1e-6, 1);
        return plot_svg(chart);
    };
    CHECK(is_well_formed(svg()));
    chart.series.push_back({.name = "one", .points = {{1, 0.5}}, .labels = {"label"}});
    CHECK(is_well_formed(svg()));
    CHECK(svg().find(">label<") != std::string::npos);
    chart.series.push_back(
        {.name = "absurd", .points = {{1e-9, 0}, {1e9, 1e300}, {3, 1e-300}, {4, INFINITY}, {5, NAN}}});
    CHECK(is_well_formed(svg()));
    CHECK(svg().find("nan") == std::string::npos);
    CHECK(svg().find("inf") == std::string::npos);
    CHECK(xml_text("a<b>&\"c\"\n") == "a&lt;b&gt;&amp;&quot;c&quot;\\n");
}

TEST_CASE("a report stops soon after it is asked to") {
    std::stop_source stop;
    std::jthread asker([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        stop.request_stop();
    });
    const auto begin = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(measure_accuracy(slanted_velvet(1, true), {}, stop.get_token()), BakeCancelled);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(1));
}

TEST_SUITE_END();
