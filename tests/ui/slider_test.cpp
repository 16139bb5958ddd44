// Every slider: drag, type, and back to the default.
#include <cmath>

#include "tests/ui/panel_rig.h"
#include "ui/canvas_toolbar.h"
#include "ui/hemisphere_canvas.h"
#include "ui/widgets.h"

using namespace nacre;

namespace {

constexpr ui::SliderSpec width{.label = "Width",
                               .low = 1e-3,
                               .high = 10,
                               .least = 1e-4,
                               .most = 100,
                               .reset = 0.2,
                               .format = "%.4g",
                               .logarithmic = true,
                               .tooltip = nullptr};

}  // namespace

TEST_CASE("slider: a double click and the context menu bring the default, Ctrl+click types") {
    double value = 3;
    PanelRig rig([&] { ui::slider(width, value); });
    rig.double_click("Width", 0.9f);
    CHECK(value == 0.2);
    rig.enter_number("Width", "42.125");
    CHECK(value == 42.125);
    rig.click("Width", 0.5f, 0.5f, 1);
    CHECK(value == 42.125);
    rig.click("Width reset");
    CHECK(value == 0.2);
}

TEST_CASE("slider: a click moves nothing, a drag moves the mark as far as the pointer goes") {
    double value = 3;
    PanelRig rig([&] { ui::slider(width, value); });
    for (const float at : {0.05f, 0.4f, 0.95f}) {
        rig.click("Width", at);
        CHECK(value == 3);
    }
    // From anywhere; to the right and all the way back.
    for (const float at : {0.1f, 0.9f}) {
        rig.frame(30);
        rig.move("Width", at);
        rig.button(true);
        rig.move("Width", 0.5f);
        const double there = value;
        CHECK((there > 3) == (at < 0.5f));
        rig.move("Width", at);
        rig.button(false);
        CHECK(value == doctest::Approx(3).epsilon(1e-3));
    }
    // Beyond the ends.
    rig.drag("Width", {0.2f, 0.5f}, {4, 0.5f});
    CHECK(value == width.high);
}

TEST_CASE("slider: one that can be infinite resets from there too, by its label") {
    double value = HUGE_VAL;
    PanelRig rig([&] {
        ui::slider_or_infinity(width, value);
        ui::button("Below");
    });
    ImGui::GetIO().MousePos = ImVec2(20, 20);  // on the label, left of the field
    rig.frame(30);
    for (int click = 0; click < 2; ++click) {
        rig.button(true);
        rig.button(false);
    }
    CHECK(value == 0.2);
    rig.enter_number("Width", "7");
    CHECK(value == 7);
    rig.double_click("Width", 0.3f);
    CHECK(value == 0.2);
}

TEST_CASE("slider: each channel of a colour resets to its own default and takes typed numbers") {
    const glm::dvec3 usual(0.1, 0.5, 0.9);
    glm::dvec3 linear(0.25);
    PanelRig rig([&] { ui::colour("Tint", linear, usual); });
    rig.double_click("Tint green", 0.2f);
    CHECK(linear == glm::dvec3(0.25, 0.5, 0.25));
    rig.enter_number("Tint blue", "0.123456789");
    CHECK(linear.z == 0.123456789);
    rig.enter_number("Tint red", "7");
    CHECK(linear.x == 0.25);
    CHECK(rig.has("Tint red problem"));
}

TEST_CASE("slider: a typed comma is a decimal point; what is no number or out of range is refused and said") {
    double value = 3;
    PanelRig rig([&] {
        ui::slider(width, value);
        ui::button("Below");
    });
    rig.enter_number("Width", "0,5");
    CHECK(value == 0.5);
    CHECK(!rig.has("Width problem"));
    for (const char* text : {"nan", "inf", "infinity", "0x10", "1.234,5", "1,5 m", "1000", "0", "-1", " "}) {
        CAPTURE(text);
        rig.enter_number("Width", text);
        CHECK(value == 0.5);
        CHECK(rig.has("Width problem"));
    }
    rig.click("Below");
    rig.frame();
    CHECK(!rig.has("Width problem"));
    rig.enter_number("Width", "infinity");
    rig.enter_number("Width", "7");
    CHECK(value == 7);
    CHECK(!rig.has("Width problem"));
}

TEST_CASE("slider: infinity may be typed where a box beside it says so too") {
    double value = 3;
    PanelRig rig([&] { ui::slider_or_infinity(width, value); });
    rig.enter_number("Width", "infinity");
    CHECK(value == HUGE_VAL);
}

TEST_CASE("slider: Escape in the typed number and during a drag brings the old one, with all its digits") {
    double value = 0.123456789012345;
    PanelRig rig([&] { ui::slider(width, value); });
    rig.frame(30);
    rig.move("Width");
    rig.hold(true);
    rig.button(true);
    rig.button(false);
    rig.hold();
    rig.type("7");
    CHECK(value == 7);
    rig.key(PanelRig::escape);
    CHECK(value == 0.123456789012345);
    rig.frame(30);
    rig.move("Width", 0.3f);
    rig.button(true);
    rig.move("Width", 0.9f);
    CHECK(value > 1);
    rig.key(PanelRig::escape);
    CHECK(value == 0.123456789012345);
    rig.move("Width", 0.5f);
    rig.button(false);
    CHECK(value == 0.123456789012345);
}

TEST_CASE("slider: a number that is typed counts when another field is clicked") {
    double value = 3, other = 1;
    PanelRig rig([&] {
        ui::slider(width, value);
        ui::SliderSpec second = width;
        second.label = "Second";
        ui::slider(second, other);
    });
    rig.frame(30);
    rig.move("Second");
    rig.hold(true);
    rig.button(true);
    rig.button(false);
    rig.hold();
    rig.type("2,5");
    rig.click("Width", 0.5f);
    CHECK(other == 2.5);
}

TEST_CASE("slider: one of whole numbers takes no fractions") {
    double value = 5;
    ui::SliderSpec rays = width;
    rays.least = rays.low = 3;
    rays.most = rays.high = 24;
    rays.format = "%.0f rays";
    rays.logarithmic = false;
    rays.whole = true;
    PanelRig rig([&] { ui::slider(rays, value); });
    rig.enter_number("Width", "4,5");
    CHECK(value == 5);
    rig.enter_number("Width", "9 rays");
    CHECK(value == 9);
    rig.drag("Width", {0.1f, 0.5f}, {0.63f, 0.5f});
    CHECK(value == std::round(value));
}

TEST_CASE("slider: those of the brush") {
    ui::CanvasState state;
    Distribution distribution;
    std::size_t chosen = 0;
    PanelRig rig([&] { ui::canvas_toolbar(state, {}, distribution, chosen); });
    state.tool = ui::CanvasTool::paint;
    state.symmetry.kind = SymmetryKind::turns;
    const Brush usual;
    for (const char* name : {"Brush radius", "Hardness", "Flow", "Turns"}) {
        CAPTURE(name);
        rig.enter_number(name, "17");
        rig.frame(30);
    }
    CHECK(state.brush.radius == 17);
    CHECK(state.brush.hardness == doctest::Approx(0.17));
    CHECK(state.brush.flow == doctest::Approx(0.17));
    CHECK(state.symmetry.turns == 17);
    for (const char* name : {"Brush radius", "Hardness", "Flow", "Turns"}) rig.double_click(name, 0.8f);
    CHECK(state.brush.radius == usual.radius);
    CHECK(state.brush.hardness == usual.hardness);
    CHECK(state.brush.flow == usual.flow);
    CHECK(state.symmetry.turns == BrushSymmetry{}.turns);
    state.tool = ui::CanvasTool::star;
    rig.enter_number("Rays", "9");
    CHECK(state.rays == 9);
    rig.double_click("Rays", 0.8f);
    CHECK(state.rays == usual_rays);
}

TEST_CASE("colour: six hexadecimal digits are the displayed colour; fewer change nothing") {
    glm::dvec3 linear(0.25, 0.5, 0.123456789);
    PanelRig rig([&] { ui::colour("Tint", linear, glm::dvec3(0)); });
    rig.click("Tint swatch");
    rig.frame(3);
    const auto enter = [&](const char* text) {
        rig.click("Tint hexadecimal");
        rig.key('A', true);
        rig.type(text);
        rig.key(PanelRig::enter);
    };
    const glm::dvec3 before = linear;
    for (const char* text : {"#12", "nonsense", "0x1234", "#12345", "-12345", "+12345", "12 345"}) {
        CAPTURE(text);
        enter(text);
        CHECK(linear == before);
    }
    enter("#ff0000");
    CHECK(linear == glm::dvec3(1, 0, 0));
    CHECK(!rig.has("Tint hexadecimal"));  // Enter on a colour is done with it
    linear.z = 0.123456789;
    rig.click("Tint swatch");
    rig.frame(3);
    enter("00ff63");  // the blue that was there, in eight bits
    CHECK(linear == glm::dvec3(0, 1, 0.123456789));
}
