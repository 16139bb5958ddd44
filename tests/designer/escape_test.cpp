// Escape closes what is on top: one thing for each press, and nothing under it.
#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::Rig;

namespace {

int open_popups() { return ImGui::GetCurrentContext()->OpenPopupStack.Size; }

// Holds the button at `from`, moves to `to`, presses Escape and lets go.
std::string taken_back(const std::string& from, const std::string& to, const std::string& button = "left") {
    return "frames 30\nmove " + from + "\ndown " + button + "\nmove " + to +
           "\nframes 3\nkey Escape\nframes 2\nup " + button + "\nframes 30";
}

}  // namespace

TEST_CASE("escape: closes a list, a menu and a menu of one's own, and changes nothing") {
    Rig r;
    const Design before = r.document().design;
    for (const char* name : {"\"Lobe\"", "\"File\"", "\"Edit\"", "\"Help\"", "\"Add layer\"", "\"Symmetry\"",
                             "\"Layer 1\" right", "\"Width x\" right"}) {
        CAPTURE(name);
        if (std::string(name) == "\"Symmetry\"") r.play("key B");
        r.play("frames 30\nclick " + std::string(name) + "\nframes 5");
        CHECK(open_popups() == 1);
        r.play("key Escape\nframes 20");
        CHECK(open_popups() == 0);
    }
    CHECK(r.document().design == before);
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
}

TEST_CASE("escape: a menu inside a menu goes first, though the pointer rests on its entry") {
    Rig r;
    r.designer().recent.note("/nowhere/satin.nacre");
    r.play("click \"File\"\nframes 5\nclick \"Open recent\"\nframes 5");
    CHECK(open_popups() == 2);
    r.play("key Escape\nframes 20");
    CHECK(open_popups() == 1);
    r.play("key Escape\nframes 20");
    CHECK(open_popups() == 0);
}

TEST_CASE("escape: the colours beside a swatch close, and a drag in them is taken back first") {
    Rig r;
    r.play("click \"Material\"\nframes 3");
    const Design before = r.document().design;
    r.play("click \"f0 swatch\"\nframes 5");
    CHECK(open_popups() == 1);
    r.play("move \"f0 picker\":0.45,0.45\ndown left\nframes 2\nmove \"f0 picker\":0.5,0.55\nframes 2");
    CHECK(r.document().design != before);
    r.play("key Escape\nframes 2\nup left\nframes 2");
    CHECK(r.document().design == before);
    CHECK(open_popups() == 1);
    r.play("key Escape\nframes 5");
    CHECK(open_popups() == 0);
}

TEST_CASE("escape: in a field it brings the old text, in a dialog it closes that alone") {
    Rig r;
    r.play("click \"Layer name\"\nframes 3\ntext \"Sheen\"\nframes 3");
    CHECK(r.layers()[0].name == "Sheen");
    r.play("key Escape\nframes 3");
    CHECK(r.layers()[0].name.empty());

    r.play("key Ctrl+E\nframes 5\nclick \"Format Picture, PNG\"\nframes 30\nmove \"Width\"\nframes 2");
    const double usual = r.designer().exporter.options().width;
    r.play("down left\nmove \"Width\":0.9\nframes 2");
    CHECK(r.designer().exporter.options().width > usual);
    r.play("key Escape\nframes 2\nup left\nframes 3");
    CHECK(r.designer().exporter.options().width == usual);
    CHECK(r.designer().exporter.talking());
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().exporter.talking());
}

TEST_CASE("escape: a name typed for a file goes first, then the dialog") {
    Rig r;
    r.play("key Ctrl+Shift+S\nframes 5\ntext \"satin\"\nframes 3\nkey Escape\nframes 3");
    CHECK(r.designer().files.talking());
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().files.talking());
    r.play("key Ctrl+O\nframes 5\nkey Escape\nframes 3");
    CHECK(!r.designer().files.talking());
}

TEST_CASE("escape: a drag is taken back, whatever it pulls") {
    Rig r;
    r.play("wait");
    const Design design = r.document().design;
    const Scene scene = r.designer().scene;
    const Layout layout = r.designer().settings.values.layout;
    const auto camera = r.canvas().camera;
    const auto as_before = [&](const char* what) {
        CAPTURE(what);
        CHECK(r.document().design == design);
        CHECK(!r.document().history.can_undo());
        CHECK(r.designer().scene == scene);
        CHECK(r.designer().settings.values.layout == layout);
        CHECK(r.canvas().camera == camera);
        CHECK(!ImGui::IsAnyItemActive());
    };
    r.play(taken_back("\"Width x\":0.3", "\"Width x\":0.8"));
    as_before("slider");
    r.play(taken_back("\"Canvas\":@0,0", "\"Canvas\":@40,30"));
    as_before("handle");
    r.play(taken_back("\"Preview\":0.5", "\"Preview\":0.6"));
    as_before("light");
    r.play(taken_back("\"Preview\":0.5", "\"Preview\":0.7", "right"));
    as_before("object");
    r.play(taken_back("\"Canvas\":0.5", "\"Canvas\":0.6", "right"));
    as_before("canvas");
    r.play(taken_back("\"Canvas border\"", "\"Canvas\":0.7"));
    as_before("border");
    r.play("key B");
    r.play(taken_back("\"Canvas\":0.4", "\"Canvas\":0.6"));
    as_before("stroke");
    r.play("key L");
    r.play(taken_back("\"Canvas\":0.4", "\"Canvas\":0.6"));
    as_before("line");
    r.play("key G");
    r.play(taken_back("\"Canvas\":0.5", "\"Canvas\":0.6"));
    as_before("grab");
    // What comes after is an edit like any other.
    r.play("key V\nframes 30\ndrag \"Width x\":0.3 \"Width x\":0.8");
    CHECK(r.document().history.can_undo());
}

TEST_CASE("escape: points of a curve, carried layers, plots and the line between two pictures go back too") {
    Rig r;
    CurveLobe curve;
    curve.points = {{0, 1}, {20, 0.5}, {60, 0}};
    r.layers()[0].lobe = curve;
    r.play("frames 5\nclick \"Duplicate layer\"\nframes 30");
    const Design design = r.document().design;
    r.play(taken_back("\"Curve point 2\"", "\"Curve\":0.6,0.2"));
    CHECK(r.document().design == design);
    r.play(taken_back("\"Curve\":0.8,0.2", "\"Curve\":0.7,0.4"));  // a new point
    CHECK(r.document().design == design);
    r.play("move \"Layer 1\"\ndown left\nmove \"Layer 2\":0.5,0.9\nframes 3");
    CHECK(r.designer().layers.carried);
    r.play("key Escape\nframes 2\nup left\nframes 30");
    CHECK(!r.designer().layers.carried);
    CHECK(r.document().design == design);

    r.play("click \"Plots\"\nframes 3\nclick \"Plot lobe\"\nwait");
    const PlotSettings plot = r.designer().plots.state.settings;
    r.play(taken_back("\"Plot incidence\":0.3", "\"Plot incidence\":0.8"));
    CHECK(r.designer().plots.state.settings == plot);
    CHECK(r.designer().plots.state.open);
    r.play("click \"Compare\"\nframes 3\nclick \"View Divider\"\nframes 5");
    r.play(taken_back("\"Divider\"", "\"Preview\":0.8"));
    CHECK(r.designer().preview.look.divider == 0.5);
}

TEST_CASE("escape: what is at rest stays as it is") {
    Rig r;
    r.play("frames 30\ndrag \"Width x\":0.3 \"Width x\":0.8\nframes 30");
    const Design edited = r.document().design;
    r.play("key Escape\nframes 5");
    CHECK(r.document().design == edited);
}

TEST_CASE("undo: a double click on a slider is one step, a click none, two drags are two") {
    Rig r;
    const Design before = r.document().design;
    r.play("frames 60\nclick \"Width x\":0.9\nclick \"Width x\":0.9\nframes 60");
    CHECK(std::get<GaussianLobe>(r.layers()[0].lobe).sigma_x == 0.2);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_undo());

    r.play("frames 60\nclick \"Width x\":0.9\nframes 60");
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_undo());
    r.play("drag \"Width x\":0.3 \"Width x\":0.5");
    const Design once = r.document().design;
    r.play("drag \"Width y\":0.3 \"Width y\":0.5\nframes 60\nkey Ctrl+Z\nframes 3");
    CHECK(r.document().design == once);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == before);
}
