// Pictures dropped on the window.
#include "app/designer/picture_drop.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "core/exchange/image_file.h"
#include "core/model/facet_distribution.h"
#include "core/paint/painted_layer.h"
#include "tests/designer/rig.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

struct Rig : test::Rig {
    fs::path folder = fs::temp_directory_path() / ("nacre-drop-test-" + std::to_string(std::rand()));
    Rig() : test::Rig(2) { fs::create_directories(folder); }
    ~Rig() { fs::remove_all(folder); }
    std::string quoted(const char* name) { return "\"" + (folder / name).string() + "\""; }
};

// Steel brushed along y: grooves whose sides lean along x, a little noise along y.
void write_brushed_steel(const fs::path& file) {
    constexpr int side = 64;
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::vector<float> rgb;
    std::vector<double> groove(side);
    for (double& slope : groove) slope = 0.3 * normal(random);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const glm::dvec3 n = glm::normalize(
                glm::dvec3(groove[static_cast<std::size_t>(column)], 0.02 * normal(random), 1));
            for (int i = 0; i < 3; ++i) rgb.push_back(static_cast<float>(0.5 + 0.5 * n[i]));
        }
    write_image(file, {side, side}, rgb);
}

}  // namespace

TEST_CASE("picture: a brushed-steel normal map gives a streak across the brushing") {
    Rig r;
    write_brushed_steel(r.folder / "steel.exr");
    const Design before = r.stage.designer().document.design;
    r.play("drop " + r.quoted("steel.exr") + "\nframes 3\nclick \"Normals\"\nframes 3\nwait");
    REQUIRE(r.layers().size() == 2);
    CHECK(r.layers()[1].name == "steel");
    CHECK(r.layers()[1].enabled);
    CHECK(r.stage.designer().baker.problem().empty());
    Distribution alone;
    alone.layers = {r.layers()[1]};
    const FacetDistribution p(alone);
    double xx = 0, yy = 0;
    const auto facets = p.facets(0);
    for (const Facet& facet : facets.front()) {
        xx += facet.mass * facet.h.x * facet.h.x;
        yy += facet.mass * facet.h.y * facet.h.y;
    }
    CHECK(std::sqrt(xx) > 0.2);
    CHECK(std::sqrt(xx / yy) > 5);
    r.play("key Ctrl+Z");
    CHECK(r.stage.designer().document.design == before);
}

TEST_CASE("picture: it becomes the stamp in hand, or the chosen layer's modulation") {
    Rig r;
    const std::vector<float> rgb = {1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1};
    write_image(r.folder / "check.png", {2, 2}, rgb);
    r.play("drop " + r.quoted("check.png") + "\nframes 3\nclick \"Stamp\"\nframes 3");
    CHECK(r.canvas().tool == ui::CanvasTool::stamp);
    REQUIRE(r.canvas().stamp < r.canvas().stamps.size());
    CHECK(r.canvas().stamps[r.canvas().stamp].name == "check");
    r.canvas().brush.radius = 30;
    r.play("click \"Canvas\":@0,0\nwait");
    REQUIRE(r.layers().size() == 2);
    CHECK(raster_mass(*std::get<PaintedLobe>(r.layers()[1].lobe).image.raster) > 0.1);
    r.play("click \"Layer 1\"\ndrop " + r.quoted("check.png") +
           "\nframes 3\nclick \"Modulation\"\nframes 3\nwait");
    CHECK(r.layers()[0].modulation.has_value());
    CHECK(r.stage.designer().baker.problem().empty());
}

TEST_CASE("picture: what is none is told, and nothing changes") {
    Rig r;
    std::ofstream(r.folder / "words.png") << "not a picture";
    const Design before = r.stage.designer().document.design;
    r.play("drop " + r.quoted("words.png") + "\nframes 3\nclick \"Heights\"\nframes 3");
    CHECK(r.stage.designer().pictures.talking());
    r.play("key Enter\nframes 3");
    CHECK(!r.stage.designer().pictures.talking());
    r.play("drop " + r.quoted("words.png") + "\nframes 3\nkey Escape\nframes 3");
    CHECK(!r.stage.designer().pictures.talking());
    CHECK(r.stage.designer().document.design == before);
}
