// The drawer of plots, used as by hand.
#include <doctest/doctest.h>

#include <filesystem>

#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;

namespace {

struct Rig : test::Rig {
    PlotsPane& plots() { return designer().plots; }
    PlotSettings& settings() { return plots().state.settings; }
};

}  // namespace

TEST_CASE("plots: the drawer opens, reads the value under the pointer, and closes") {
    Rig r;
    const Design before = r.document().design;
    CHECK(!r.plots().plot());
    r.play("click \"Plots\"\nwait\nmove \"Plot\":0.3,0.5\nframes 2");
    REQUIRE(r.plots().plot());
    REQUIRE(r.plots().reading());
    const auto& curves = std::get<CurvePlot>(r.plots().plot()->contents);
    const PlotReading& reading = *r.plots().reading();
    CHECK(reading.at.x > 5);
    CHECK(reading.at.x < 60);
    for (std::size_t i = 0; i < curves.series.size(); ++i)
        CHECK(reading.values.at(i) == curves.value(i, reading.at.x));
    r.play("move 5 5\nframes 1");
    CHECK(!r.plots().reading());
    r.play("click \"Close plots\"\nframes 2");
    CHECK(!r.plots().state.open);
    CHECK(r.document().design == before);
    CHECK(!r.stage.items().rectangle("Plot"));
}

TEST_CASE("plots: R is baked only while its plot is shown, and follows the design") {
    Rig r;
    r.document().design.diffuse = NoDiffuse{};
    r.document().commit();
    r.play("click \"Plots\"\nclick \"Plot masking\"\nwait");
    CHECK(!r.plots().wants_albedo());
    r.play("click \"Plot albedo\"\nwait\nframes 2");
    REQUIRE(r.plots().plot());
    const auto R = [&] { return std::get<CurvePlot>(r.plots().plot()->contents).value(0, 30); };
    const double pale = R();
    r.document().design.fresnel = SchlickFresnel{glm::dvec3(0.8)};
    r.document().commit();
    r.play("wait\nframes 2");
    CHECK(R() > 5 * pale);
}

TEST_CASE("plots: a drag in the polar plot moves the light, in the space one it turns the shape") {
    Rig r;
    r.play("click \"Plots\"\nclick \"Plot lobe\"\nwait\ndrag \"Plot\":0.4,0.5 \"Plot\":0.15,0.9");
    CHECK(r.settings().incidence > 70);
    CHECK(r.settings().incidence <= incidence_max);
    const auto incidence = [&] { return std::get<LobePlot>(r.plots().plot()->contents).incidence; };
    r.play("frames 1");
    CHECK(incidence() == r.settings().incidence);
    const ShapeView before = r.plots().state.view;
    r.play("click \"Plot lobe3d\"\nframes 30\ndrag \"Plot\":0.4,0.5 \"Plot\":0.5,0.6");
    CHECK(r.plots().state.view.yaw > before.yaw);
    CHECK(r.plots().state.view.pitch > before.pitch);
}

TEST_CASE("plots: each term can be seen alone, and each plot as logarithms") {
    Rig r;
    r.play("click \"Plots\"\nclick \"Plot slice\"\nwait");
    CHECK(r.settings().is_logarithmic());
    r.play("click \"Plot scale\"");
    CHECK(!r.settings().is_logarithmic());
    r.settings().term = Term::masking1;
    r.play("frames 2\nmove \"Plot\":0.1,0.5\nframes 2");
    REQUIRE(r.plots().reading());
    CHECK(r.plots().reading()->values[0] <= 1);
    CHECK(std::get<SlicePlot>(r.plots().plot()->contents).shade.high == 1);
}

TEST_CASE("plots: the drawer's border is dragged") {
    Rig r;
    r.play("click \"Plots\"\nframes 2");
    const float before = r.stage.items().rectangle("Plot")->y;
    r.play("move \"Plots border\"\ndown left\nmove 700 400\nup left\nframes 2");
    CHECK(r.stage.items().rectangle("Plot")->y < before - 50);
    CHECK(r.stage.items().rectangle("Canvas")->w < 400);
}

TEST_CASE("plots: a plot is saved through the dialog, and an existing file is asked about") {
    Rig r;
    const test::TemporaryFolder folder;
    const std::string path = (folder / "p.csv").string();
    r.play(
        "click \"Plots\"\nclick \"Plot masking\"\nwait\nclick \"Save plot\"\nframes 2\nkey Ctrl+A\ntext \"" +
        path + "\"\nkey Enter\nframes 2");
    CHECK(std::filesystem::exists(path));
    CHECK(r.designer().files.message() == "Saved p.csv");
    CHECK(!r.plots().saving.talking());
    r.play("click \"Save plot\"\nframes 2\nkey Ctrl+A\ntext \"" + path + "\"\nkey Enter\nframes 2");
    CHECK(r.plots().saving.talking());
    r.play("click \"Cancel\"\nframes 2");
    CHECK(!r.plots().saving.talking());
    CHECK(folder.size() == 1);
}
