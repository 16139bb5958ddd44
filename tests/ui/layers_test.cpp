#include "ui/layers_panel.h"

#include <cmath>
#include <string>

#include "tests/ui/panel_rig.h"
#include "ui/widgets.h"

using namespace nacre;

namespace {

struct LayersRig {
    Distribution distribution;
    ui::LayersView view;
    bool changed = false, paints_mask = false;
    PanelRig rig{[this] { changed |= ui::layers_panel(view, distribution, paints_mask); }};

    const GaussianLobe& gaussian() const { return std::get<GaussianLobe>(distribution.layers[0].lobe); }
};

}  // namespace

TEST_CASE("layers: a width slider is logarithmic and reports its change") {
    LayersRig r;
    r.rig.frame(5);
    CHECK(!r.changed);
    const double before = r.gaussian().sigma_x;
    r.rig.drag("Width x", {0.5f, 0.5f}, {0.35f, 0.5f});
    const double once = r.gaussian().sigma_x;
    CHECK(once < 0.5 * before);
    r.rig.drag("Width x", {0.5f, 0.5f}, {0.35f, 0.5f});
    CHECK(r.gaussian().sigma_x / once == doctest::Approx(once / before).epsilon(0.02));
    r.rig.drag("Width x", {0.5f, 0.5f}, {1.5f, 0.5f});
    CHECK(r.gaussian().sigma_x == 10);
    CHECK(r.gaussian().sigma_y == 0.2);
    CHECK(r.changed);
    r.rig.enter_number("Width x", "0.4");
    r.rig.click("Link x and y");
    r.rig.enter_number("Width x", "0.2");
    CHECK(r.gaussian().sigma_x == doctest::Approx(0.2));
    CHECK(r.gaussian().sigma_y == doctest::Approx(0.1));
    r.rig.enter_number("Width y", "0.3");
    CHECK(r.gaussian().sigma_x == doctest::Approx(0.6));
}

TEST_CASE("layers: softness and stretch set both widths; without the numbers they are all there is") {
    LayersRig r;
    r.rig.frame(3);
    r.rig.enter_number("Stretch", "4");
    CHECK(r.gaussian().sigma_x == doctest::Approx(0.4));
    CHECK(r.gaussian().sigma_y == doctest::Approx(0.1));
    r.rig.enter_number("Softness", "0.1");
    CHECK(r.gaussian().sigma_x == doctest::Approx(0.2));
    CHECK(r.rig.has("Tilt"));
    r.view.expert = false;
    r.rig.frame(3);
    CHECK(!r.rig.has("Tilt"));
    CHECK(!r.rig.has("Width x"));
    r.rig.enter_number("Rotation", "30");
    CHECK(r.distribution.layers[0].rotation == 30);
}

TEST_CASE("layers: typed numbers beyond the limits are refused") {
    LayersRig r;
    r.rig.enter_number("Width x", "250");
    CHECK(r.gaussian().sigma_x == 250);
    for (const char* text : {"1e999", "-3", "100001", "0"}) {
        CAPTURE(text);
        r.rig.enter_number("Width x", text);
        CHECK(r.gaussian().sigma_x == 250);
        CHECK(r.rig.has("Width x problem"));
    }
    r.rig.enter_number("Width x", "100000");
    CHECK(r.gaussian().sigma_x == limits::width_max);
    r.rig.enter_number("Width x", "1e-5");
    CHECK(r.gaussian().sigma_x == limits::width_min);
    const double weight = r.distribution.layers[0].weight;
    r.rig.enter_number("Weight", "-1");
    CHECK(r.distribution.layers[0].weight == weight);
}

TEST_CASE("layers: a double click brings the default back, and so does the context menu") {
    LayersRig r;
    r.rig.drag("Tilt", {0.1f, 0.5f}, {0.6f, 0.5f});
    CHECK(r.distribution.layers[0].tilt > 10);
    r.rig.double_click("Tilt", 0.6f);
    CHECK(r.distribution.layers[0].tilt == 0);
}

TEST_CASE("layers: the infinite box makes a cylinder and back") {
    LayersRig r;
    r.rig.click("Width y infinite", 0.2f);
    CHECK(std::isinf(r.gaussian().sigma_y));
    r.rig.click("Width y infinite", 0.2f);
    CHECK(r.gaussian().sigma_y == 0.2);
}

TEST_CASE("layers: add, duplicate, reorder, disable and delete") {
    LayersRig r;
    r.rig.click("Add layer");
    r.rig.click("Add GGX");
    REQUIRE(r.distribution.layers.size() == 2);
    CHECK(std::holds_alternative<GgxLobe>(r.distribution.layers[1].lobe));
    CHECK(r.view.chosen == 1);
    r.rig.click("Layer up");
    CHECK(std::holds_alternative<GgxLobe>(r.distribution.layers[0].lobe));
    CHECK(r.view.chosen == 0);
    r.rig.click("Duplicate layer");
    REQUIRE(r.distribution.layers.size() == 3);
    CHECK(r.distribution.layers[0] == r.distribution.layers[1]);
    r.rig.click("Layer 3 enabled");
    CHECK(!r.distribution.layers[2].enabled);
    r.rig.click("Delete layer");
    r.rig.click("Delete layer");
    REQUIRE(r.distribution.layers.size() == 1);
    r.rig.click("Delete layer");
    CHECK(r.distribution.layers.size() == 1);
}

TEST_CASE("layers: solo shows one layer alone and leaves the design as it is") {
    LayersRig r;
    r.rig.click("Add layer");
    r.rig.click("Add GGX");
    const Distribution design = r.distribution;
    CHECK(ui::shown(r.view, r.distribution) == design);
    r.rig.click("Layer 1 solo");
    CHECK(r.distribution == design);
    const Distribution alone = ui::shown(r.view, r.distribution);
    CHECK(alone.layers[0].enabled);
    CHECK(!alone.layers[1].enabled);
    r.rig.click("Layer 2 solo");
    CHECK(!ui::shown(r.view, r.distribution).layers[0].enabled);
    r.rig.click("Layer 2 solo");
    CHECK(ui::shown(r.view, r.distribution) == design);
    r.rig.click("Layer 2 solo");
    r.rig.click("Delete layer");
    CHECK(!r.view.solo);
}

TEST_CASE("layers: a dragged line goes where the insertion line stands, when it is let go") {
    LayersRig r;
    for (const char* name : {"b", "c", "d"}) {
        r.rig.click("Duplicate layer");
        r.distribution.layers.back().name = name;
    }
    r.distribution.layers[0].name = "a";
    const auto order = [&] {
        std::string names;
        for (const Layer& layer : r.distribution.layers) names += layer.name;
        return names;
    };
    REQUIRE(order() == "abcd");
    r.rig.move("Layer 1");
    r.rig.button(true);
    r.rig.move("Layer 3", 0.5f, 0.9f);
    CHECK(r.view.carried);
    CHECK(order() == "abcd");
    r.rig.button(false);
    CHECK(order() == "bcad");
    CHECK(r.view.chosen == 2);
    r.rig.drag("Layer 4", {0.5f, 0.5f}, {0.5f, -20});
    CHECK(order() == "dbca");
    r.rig.drag("Layer 2", {0.5f, 0.5f}, {0.5f, 20});
    CHECK(order() == "dcab");
    // Upon itself, and let go by Escape.
    r.rig.drag("Layer 2", {0.5f, 0.5f}, {0.5f, 0.9f});
    CHECK(order() == "dcab");
    r.rig.frame(30);
    r.rig.move("Layer 1");
    r.rig.button(true);
    r.rig.move("Layer 4");
    r.rig.key(PanelRig::escape);
    r.rig.move("Layer 3");
    r.rig.button(false);
    CHECK(order() == "dcab");
    CHECK(!r.view.carried);
}

TEST_CASE("layers: a double click on the name renames; Escape does not") {
    LayersRig r;
    r.rig.click("Duplicate layer");
    r.rig.double_click("Layer 2");
    r.rig.frame(3);
    REQUIRE(r.rig.has("Layer 2 name"));
    r.rig.type("Haze");
    r.rig.key(PanelRig::enter);
    CHECK(r.distribution.layers[1].name == "Haze");
    CHECK(r.distribution.layers[0].name.empty());
    CHECK(!r.view.rename);
    r.rig.double_click("Layer 2");
    r.rig.frame(3);
    r.rig.type("Core");
    r.rig.key(PanelRig::escape);
    r.rig.frame(2);
    CHECK(r.distribution.layers[1].name == "Haze");
    CHECK(!r.view.rename);
    r.rig.double_click("Layer 1");
    r.rig.frame(3);
    r.rig.type("Core");
    r.rig.click("Tilt", 0.0f);
    CHECK(r.distribution.layers[0].name == "Core");
    CHECK(!r.view.rename);
}

TEST_CASE("layers: the right button's menu acts on the layer under the pointer") {
    LayersRig r;
    r.rig.click("Duplicate layer");
    r.distribution.layers[0].name = "first";
    r.rig.click("Layer 1", 0.5f, 0.5f, 1);
    CHECK(r.view.chosen == 0);
    r.rig.click("Menu Move down");
    CHECK(r.distribution.layers[1].name == "first");
    r.rig.click("Layer 2", 0.5f, 0.5f, 1);
    r.rig.click("Menu Duplicate");
    REQUIRE(r.distribution.layers.size() == 3);
    CHECK(r.distribution.layers[2].name == "first");
    r.rig.click("Layer 1", 0.5f, 0.5f, 1);
    r.rig.click("Menu Delete");
    REQUIRE(r.distribution.layers.size() == 2);
    CHECK(r.distribution.layers[0].name == "first");
    r.rig.click("Layer 1", 0.5f, 0.5f, 1);
    r.rig.click("Menu Rename");
    r.rig.frame(3);
    r.rig.type("renamed");
    r.rig.key(PanelRig::enter);
    CHECK(r.distribution.layers[0].name == "renamed");
}

TEST_CASE("layers: no more than a file may hold") {
    LayersRig r;
    for (int i = 0; i < limits::layers_max + 3; ++i) r.rig.click("Duplicate layer");
    CHECK(r.distribution.layers.size() == limits::layers_max);
}

TEST_CASE("lobes: another kind keeps the widths it can have") {
    const Lobe brushed = GaussianLobe{0.1, limits::infinity};
    const auto ggx = GgxLobe::of_widths(widths_of(brushed));
    CHECK(ggx.alpha_x == 0.1);
    CHECK(ggx.alpha_y == 1);
    const auto back = GaussianLobe::of_widths(widths_of(ggx));
    CHECK(back.sigma_x == 0.1);
    for (std::size_t kind = 0; kind < KindSet<Lobe>::count; ++kind) {
        const Lobe lobe = lobe_of_widths(kind);
        CHECK(lobe.index() == kind);
        if (const auto* painted = std::get_if<PaintedLobe>(&lobe)) REQUIRE(painted->image.raster);
        if (const auto* curve = std::get_if<CurveLobe>(&lobe))
            for (std::size_t i = 1; i < curve->points.size(); ++i)
                CHECK(curve->points[i - 1].first < curve->points[i].first);
    }
}

TEST_CASE("note: a click edits it, and leaving ends that") {
    std::string note = "Made by hand.";
    PanelRig rig([&] {
        ui::note_field(note);
        ui::button("Elsewhere");
    });
    rig.click("Note text");
    rig.frame(3);
    rig.key('A', true);
    rig.type("Two words");
    CHECK(note == "Two words");
    rig.click("Elsewhere");
    rig.frame(3);
    rig.type("x");
    CHECK(note == "Two words");
}
