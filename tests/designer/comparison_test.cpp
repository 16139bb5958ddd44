// Snapshots and comparing, driven as by hand.
#include <doctest/doctest.h>

#include <imgui.h>

#include "app/designer/comparison.h"
#include "app/headless/input.h"
#include "tests/designer/rig.h"

using namespace nacre;

namespace {

struct Rig : test::Rig {
    Comparison& comparison() { return designer().comparison; }
    ui::CompareState& state() { return comparison().state; }
    double divider() { return designer().preview.look.divider; }
    void open_list(const char* label, const char* choice) {
        play(std::string("click \"") + label + "\"\nframes 2\nclick \"" + choice + "\"\nframes 2");
    }
};

}  // namespace

TEST_CASE("compare: a snapshot stays as it was and comes back in one step of undo") {
    Rig r;
    r.play("wait\nclick \"Compare\"\nframes 2\nclick \"Take snapshot\"\nframes 2");
    REQUIRE(r.comparison().snapshots().size() == 1);
    const Design before = r.document().design;
    CHECK(r.comparison().snapshots()[0].design == before);
    CHECK(r.comparison().snapshots()[0].tables == r.designer().frame.tables);
    CHECK(!r.document().unsaved());
    r.play("click \"Layers\"\nframes 2\ndrag \"Width x\":0.5 \"Width x\":0.8 5");
    const Design edited = r.document().design;
    REQUIRE(edited != before);
    CHECK(r.comparison().snapshots()[0].design == before);
    r.play("click \"Compare\"\nframes 2\nclick \"Snapshot A restore\"\nframes 2");
    CHECK(r.document().design == before);
    r.play("key Ctrl+Z");
    CHECK(r.document().design == edited);
    r.play("click \"Snapshot A restore\" right\nframes 5\nclick \"Snapshot A remove\"\nframes 5");
    CHECK(r.comparison().snapshots().empty());
    CHECK(r.document().design == edited);
}

TEST_CASE("compare: the divider is dragged, and the light stays where it is") {
    Rig r;
    r.play("wait\nclick \"Compare\"\nframes 2");
    r.play("click \"View Divider\"\nframes 2");
    REQUIRE(r.state().view == ui::CompareView::divider);
    r.play("wait");
    const Scene before = r.designer().scene;
    CHECK(r.divider() == 0.5);
    r.play("drag \"Preview\":0.5,0.5 \"Preview\":0.25,0.5 6");
    CHECK(r.divider() == doctest::Approx(0.25).epsilon(0.02));
    CHECK(r.designer().scene == before);
    r.play("drag \"Preview\":0.6,0.5 \"Preview\":0.65,0.5 6");
    CHECK(r.divider() == doctest::Approx(0.25).epsilon(0.02));
    CHECK(r.designer().scene != before);
}

TEST_CASE("compare: the present design differs from its snapshot by nothing until it is edited") {
    Rig r;
    r.play("wait\nclick \"Compare\"\nframes 2\nclick \"Take snapshot\"\nframes 2");
    r.play("click \"View Difference\"\nframes 2");
    CHECK(r.state().left >= 100);
    CHECK(r.state().right == 0);
    r.play("wait");
    REQUIRE(r.designer().preview.difference());
    CHECK(r.designer().preview.difference()->largest == 0);
    r.play("click \"Layers\"\nframes 2\ndrag \"Width x\":0.5 \"Width x\":0.8 5\nwait");
    CHECK(r.designer().preview.difference()->largest > 0.01);
}

TEST_CASE("compare: a snapshot has a picture, and its menu sets the sides") {
    Rig r;
    r.play("wait\nclick \"Compare\"\nframes 2\nclick \"Take snapshot\"\nframes 2");
    CHECK(r.frames_until([&] { return r.comparison().picture_of("A") != nullptr; }));
    r.play("click \"Take snapshot\"\nframes 2");
    CHECK(r.frames_until([&] { return r.comparison().picture_of("B") != nullptr; }));
    CHECK(r.comparison().picture_of("A") != nullptr);
    const int a = r.comparison().snapshots()[0].id, b = r.comparison().snapshots()[1].id;
    r.play("click \"Snapshot A restore\" right\nframes 5\nclick \"Snapshot A left\"\nframes 5");
    CHECK(r.state().left == a);
    r.play("click \"Snapshot B restore\" right\nframes 5\nclick \"Snapshot B right\"\nframes 5");
    CHECK(r.state().right == b);
    CHECK(r.state().left == a);
    r.play("click \"Snapshot A restore\" right\nframes 5\nclick \"Snapshot A remove\"\nframes 20");
    CHECK(r.comparison().picture_of("A") == nullptr);
    CHECK(r.comparison().picture_of("B") != nullptr);
}

TEST_CASE("compare: a tap of A shows the snapshot in place and back, held it lasts as long as the key") {
    Rig r;
    const auto alone = [&] { return r.designer().preview.look.alone; };
    r.designer().preview.insist_on_best();
    r.designer().canvas.insist_on_best();
    r.play("wait\nkey A\nframes 3");
    CHECK(!alone());
    CHECK(r.designer().files.message() == "Nothing to compare with yet: take a snapshot in Compare");
    r.play("click \"Compare\"\nframes 2\nclick \"Take snapshot\"\nframes 2\nclick \"Layers\"\nframes 2");
    r.play("drag \"Width x\":0.5 \"Width x\":0.8 5\nwait");
    r.play("move 300 700\nframes 30");  // nothing there explains itself
    r.stage.frame();
    const auto edited = r.stage.pixels();
    r.play("key A\nframes 3\nwait\nframes 30");
    REQUIRE(alone());
    CHECK(*alone() == 0);
    CHECK(r.designer().preview.look.labels[0] == "A");
    r.stage.frame();
    CHECK(r.stage.pixels() != edited);
    r.play("key A\nframes 30");
    CHECK(!alone());
    r.stage.frame();
    CHECK(r.stage.pixels() == edited);
    // Held for half a second.
    const ui::KeyPress key{.key = 'A'};
    set_key(ImGui::GetIO(), key, true);
    r.play("frames 30");
    CHECK(alone());
    set_key(ImGui::GetIO(), key, false);
    r.play("frames 3");
    CHECK(!alone());
}

TEST_CASE("compare: an edit shows the design again, and so does the end of the snapshot") {
    Rig r;
    const auto alone = [&] { return r.designer().preview.look.alone.has_value(); };
    r.play("wait\nclick \"Compare\"\nframes 2\nclick \"Take snapshot\"\nframes 2\nkey A\nframes 2");
    CHECK(alone());
    r.play("click \"Layers\"\nframes 2");
    CHECK(alone());
    r.play("drag \"Width x\":0.5 \"Width x\":0.8 5\nframes 2");
    CHECK(!alone());
    r.play("key A\nframes 2");
    CHECK(alone());
    r.comparison().remove(0);
    r.play("frames 2");
    CHECK(!alone());
    CHECK(!r.comparison().shows_other());
}

TEST_CASE("compare: each comparison model can be chosen and is baked without a wait of the interface") {
    Rig r;
    r.layers()[0].lobe = GaussianLobe{0.8, 0.8};  // rough, so that maskings differ
    r.play("wait\nclick \"Compare\"\nframes 2");
    r.play("click \"View Difference\"\nframes 2");
    for (const ComparisonModel& comparison_model : all_comparison_models()) {
        CAPTURE(label_of(comparison_model));
        r.open_list("Right", label_of(comparison_model).c_str());
        r.play("wait\nframes 2");
        CHECK(r.comparison().problem().empty());
        REQUIRE(r.designer().preview.difference());
        const double rms = r.designer().preview.difference()->root_mean_square;
        // The starter's own masking is the uncorrelated one.
        if (comparison_model == ComparisonModel(MaskingModel(UncorrelatedMasking{}))) {
            CHECK(rms == 0);
        } else {
            CHECK(rms > 0);
        }
    }
}

TEST_CASE("compare: a factor is shown alone; a model without factors shows none") {
    Rig r;
    r.play("wait\nclick \"Show P2\"\nframes 2");
    CHECK(r.designer().scene.term == Term::masking2);
    r.play("click \"Compare\"\nframes 2");
    r.state().right = 0;
    r.play("click \"View Divider\"\nframes 2");
    CHECK(r.designer().scene.term == Term::masking2);
    r.open_list("Right", "Ward");  // cannot be chosen now
    CHECK(r.state().right == 0);
    r.play("click \"Compare\"\nframes 2\nclick \"Show total\"\nframes 2");
    r.open_list("Right", "Ward");
    CHECK(r.state().right == 1);
    r.play("wait\nclick \"Show P2\"\nframes 2");
    CHECK(r.designer().scene.term == Term::total);
    r.play("click \"Show specular\"\nframes 2");
    CHECK(r.designer().scene.term == Term::specular);
}
