// p(theta) drawn by hand.
#include "ui/curve_editor.h"

#include <cmath>

#include "core/model/facet_distribution.h"
#include "tests/ui/panel_rig.h"
#include "ui/curve_shapes.h"

using namespace nacre;

namespace {

struct CurveRig {
    CurveLobe curve{{{0, 1}, {20, 0.5}, {45, 0}}};
    ui::CurveView view;
    int changes = 0;
    PanelRig rig{[this] {
        const CurveLobe before = curve;
        changes += ui::curve_editor(view, curve);
        CHECK(rising());
        if (curve != before) CHECK(changes > 0);
    }};

    ui::CurvePoints& points() { return curve.points; }
    bool rising() const {
        for (std::size_t i = 1; i < curve.points.size(); ++i)
            if (!(curve.points[i - 1].first < curve.points[i].first)) return false;
        return true;
    }
};

}  // namespace

TEST_CASE("curve axes: each height has its value, 0 stands on the floor") {
    const ui::CurvePoints points = {{0, 3}, {10, 0.02}, {20, 1e-5}, {40, 0}};
    for (const bool logarithmic : {false, true}) {
        CAPTURE(logarithmic);
        const ui::CurveAxes axes = ui::axes_for(points, logarithmic, 90);
        CHECK(axes.logarithmic() == logarithmic);
        CHECK(axes.height(0) == 0);
        CHECK(axes.value(0) == 0);
        CHECK(axes.height(axes.top) == doctest::Approx(1));
        CHECK(axes.top > 3);
        for (int i = 0; i <= 1000; ++i) {
            const double height = i / 1000.0;
            CHECK(axes.height(axes.value(height)) == doctest::Approx(height).epsilon(1e-9));
            if (i > 0) CHECK(axes.value(height) > axes.value((i - 1) / 1000.0));
        }
        for (const double mark : axes.marks()) CHECK(mark < axes.top);
        CHECK(axes.marks().size() >= 3);
    }
}

TEST_CASE("curve axes: logarithmic ones hold four decades, and more where points lie lower") {
    CHECK(ui::axes_for({{0, 1}, {90, 0}}, true, 90).least == doctest::Approx(1e-4));
    CHECK(ui::axes_for({{0, 1}, {90, 2e-6}}, true, 90).least == doctest::Approx(1e-6));
    CHECK(ui::axes_for({{0, 1}, {90, 1e-30}}, true, 90).least == doctest::Approx(1e-8));
    CHECK(ui::axes_for({{0, 0}, {90, 0}}, true, 90).logarithmic());
    CHECK(ui::axes_for({{0, 1}, {120, 0}}, true, 90).angle_end == 180);
    CHECK(ui::axes_for({{0, 1}, {120, 0}}, true, 30).angle_end == 30);
    // The smallest and the largest numbers that a design may hold.
    for (const double value : {5e-324, 1e-300, limits::weight_max})
        for (const bool logarithmic : {false, true})
            CHECK(ui::axes_for({{0, value}, {90, 0}}, logarithmic, 90).marks().size() <= 10);
}

TEST_CASE("curve axes: what is drawn between the points is the lobe's p") {
    const CurveLobe curve{{{2, 1}, {20, 0.25}, {45, 0.5}, {60, 0}}};
    Distribution distribution;
    distribution.layers[0].lobe = curve;
    const FacetDistribution p(distribution);
    const auto at = [&](double angle) {
        const double theta = angle * 3.14159265358979323846 / 180;
        return p.density({std::sin(theta), 0, std::cos(theta)});
    };
    for (const double angle : {1.0, 3.0, 11.0, 19.9, 33.0, 52.0, 59.0, 61.0}) {
        CAPTURE(angle);
        CHECK(at(angle) / at(20) ==
              doctest::Approx(ui::curve_value(curve.points, angle) / 0.25).epsilon(1e-5));
    }
}

TEST_CASE("curve: a point is dragged between its neighbours, on either kind of height") {
    for (const bool logarithmic : {false, true}) {
        CAPTURE(logarithmic);
        CurveRig r;
        r.view.logarithmic = logarithmic;
        r.rig.drag("Curve point 2", {0.5f, 0.5f}, {60, -1});
        CHECK(r.points()[1].first == doctest::Approx(44.99));
        CHECK(r.points()[1].second > 0.5);
        CHECK(r.points().size() == 3);
        r.rig.drag("Curve point 2", {0.5f, 0.5f}, {0.5f, 60});
        CHECK(r.points()[1].second == 0);
        CHECK(r.points()[0] == std::pair(0.0, 1.0));
    }
}

TEST_CASE("curve: four decades below the peak are drawn as easily as the peak") {
    CurveRig r;
    r.view.logarithmic = true;
    const ui::CurveAxes axes = ui::axes_for(r.points(), true, 90);
    r.rig.drag("Curve point 2", {0.5f, 0.5f}, {0.5f, 0.5f});
    const auto fraction = [&](double value) { return 1 - static_cast<float>(axes.height(value)); };
    r.rig.click("Curve", 0.4f, fraction(3e-4));
    REQUIRE(r.points().size() == 4);
    CHECK(r.points()[2].first == doctest::Approx(36).epsilon(0.01));
    CHECK(r.points()[2].second == doctest::Approx(3e-4).epsilon(0.05));
    r.rig.click("Curve", 0.8f, fraction(0));
    REQUIRE(r.points().size() == 5);
    CHECK(r.points()[4].second == 0);
}

TEST_CASE("curve: nothing moves under the pointer, however high a point is dragged") {
    CurveRig r;
    r.rig.move("Curve point 1");
    r.rig.button(true);
    r.rig.move("Curve", 0.f, 0.02f);
    const double high = r.points()[0].second;
    CHECK(high > 1);
    r.rig.frame(20);
    CHECK(r.points()[0].second == high);
    r.rig.button(false);
}

TEST_CASE("curve: to look at it the other way changes nothing") {
    CurveRig r;
    r.points() = {{0, 0.123456789}, {7.0001, 1e-30}, {20, 0}, {150, 1e-9}};
    const CurveLobe before = r.curve;
    for (int i = 0; i < 3; ++i) r.rig.click("Curve scale");
    r.rig.click("Curve angles");
    r.rig.click("Curve angles 10");
    CHECK(r.view.angle_end == 10);
    r.rig.click("Curve point 1");
    CHECK(r.view.chosen == 0);
    CHECK(r.curve == before);
    CHECK(r.changes == 0);
}

TEST_CASE("curve: a click adds a point, once, and a right click or Delete removes it") {
    CurveRig r;
    r.rig.double_click("Curve", 0.8f, 0.5f);
    REQUIRE(r.points().size() == 4);
    CHECK(r.points()[3].first == doctest::Approx(72).epsilon(0.01));
    CHECK(r.view.chosen == 3);
    r.rig.key(PanelRig::remove);
    CHECK(r.points().size() == 3);
    r.rig.click("Curve", 0.8f, 0.5f);
    REQUIRE(r.points().size() == 4);
    r.rig.click("Curve point 4", 0.5f, 0.5f, 1);
    CHECK(r.points().size() == 3);
    r.rig.click("Curve point 3", 0.5f, 0.5f, 1);
    r.rig.click("Curve point 2", 0.5f, 0.5f, 1);
    CHECK(r.points().size() == 2);  // no fewer
}

TEST_CASE("curve: Delete is the plot's only while a point of it is chosen, and a field's while one types") {
    CurveRig r;
    r.rig.click("Curve point 2");
    r.rig.click("Point value");
    r.rig.key(PanelRig::remove);
    CHECK(r.points().size() == 3);
    r.rig.key(PanelRig::escape);
    CHECK(r.view.chosen == 1);
    ImGui::GetIO().MousePos = ImVec2(100, 1100);  // elsewhere
    r.rig.button(true);
    r.rig.button(false);
    CHECK(!r.view.chosen);
    r.rig.key(PanelRig::remove);
    CHECK(r.points().size() == 3);
}

TEST_CASE("curve: typed numbers are exact, within the neighbours") {
    CurveRig r;
    r.rig.click("Curve point 2");
    r.rig.enter_number("Point value", "0.12345678901");
    CHECK(r.points()[1].second == 0.12345678901);
    r.rig.enter_number("Point angle", "12.3456789");
    CHECK(r.points()[1].first == 12.3456789);
    r.rig.enter_number("Point angle", "100");
    CHECK(r.points()[1].first == 12.3456789);
    CHECK(r.rig.has("Point angle problem"));
    r.rig.enter_number("Point value", "-1");
    CHECK(r.points()[1].second == 0.12345678901);
    CHECK(r.rig.has("Point value problem"));
    r.rig.enter_number("Point angle", "12,5\u00b0");
    CHECK(r.points()[1].first == 12.5);
    CHECK(!r.rig.has("Point angle problem"));
    r.rig.click("Remove point");
    CHECK(r.points().size() == 2);
}

TEST_CASE("curve: between two angles with no room for one more nothing is added or moved") {
    ui::CurvePoints points = {{0, 1}, {10, 0.5}, {10.005, 0.4}, {10.01, 0.3}};
    const ui::CurvePoints before = points;
    CHECK(!ui::add_point(points, {10.002, 1}));
    CHECK(points == before);
    ui::set_point(points, 2, {90, 2});
    CHECK(points[2] == std::pair(10.005, 2.0));
    while (points.size() < std::size_t{limits::curve_points_max})
        REQUIRE(ui::add_point(points, {points.back().first + 0.5, 0.1}));
    CHECK(!ui::add_point(points, {5, 1}));
}

TEST_CASE("curve: each shape is a design's curve, in one press") {
    for (const ui::CurveShape& shape : ui::curve_shapes()) {
        CAPTURE(shape.name);
        CurveRig r;
        r.rig.click(shape.name);
        CHECK(r.points() == shape.points);
        Distribution distribution;
        distribution.layers[0].lobe = r.curve;
        const FacetDistribution p(distribution);
        CHECK(p.projected_area({0, 0, 1}) > 0);
    }
    const auto& haze = ui::curve_shapes()[0].points;
    double least = 1;
    for (const auto& point : haze)
        if (point.second > 0) least = std::min(least, point.second);
    CHECK(haze.front().second / least > 1e4);
}
