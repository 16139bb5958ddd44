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
    CHECK(linear.x == 1);
}

TEST_CASE("slider: those of the brush") {
    ui::CanvasState state;
    Distribution distribution;
    std::size_t chosen = 0;
    PanelRig rig([&] { ui::canvas_toolbar(state, distribution, chosen); });
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
    CHECK(state.rays == ui::usual_rays);
}
