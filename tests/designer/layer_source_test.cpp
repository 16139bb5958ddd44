// A layer that was made from a picture: its settings stay, and what they make is made again.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/design/design_file.h"
#include "core/image/image_file.h"
#include "core/model/facet_distribution.h"
#include "tests/designer/folder_rig.h"

using namespace nacre;
using test::FolderRig;
namespace fs = std::filesystem;

namespace {

// All lean up by 30 degrees.
void write_leaning(const fs::path& file) {
    std::vector<float> rgb;
    for (int i = 0; i < 64; ++i) rgb.insert(rgb.end(), {0.0f, 0.5f, 0.8660254f});
    write_image(file, {8, 8}, rgb);
}

// With a layer that such a map made.
struct Rig : FolderRig {
    Rig() {
        write_leaning(folder / "leaning.exr");
        play(drop("leaning.exr") + import("Normals"));
        REQUIRE(layers().size() == 2);
        REQUIRE(layers()[1].source);
    }
    const Layer& layer() { return layers()[1]; }
    dvec3 mean() {
        Distribution alone;
        alone.layers = {layer()};
        return FacetDistribution(alone).mean();
    }
    double lean() { return std::asin(mean().y) * 180 / std::numbers::pi; }
    std::shared_ptr<const Raster> raster() { return std::get<PaintedLobe>(layer().lobe).image.raster; }
};

}  // namespace

TEST_CASE("layer source: a setting makes the layer again, in one step of undo") {
    Rig r;
    const Design before = r.document().design;
    CHECK(r.lean() == doctest::Approx(30).epsilon(0.02));
    const double weight = r.layer().weight;
    r.play("click \"Down (DirectX)\"\nwait\nframes 3");
    CHECK(r.lean() == doctest::Approx(-30).epsilon(0.02));
    CHECK(r.layer().source->reading.green_down);
    CHECK(r.layer().weight == weight);
    CHECK(r.document().history.current() == r.document().design);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == before);
    r.play("key Ctrl+Y\nframes 3");
    CHECK(r.lean() == doctest::Approx(-30).epsilon(0.02));
}

TEST_CASE("layer source: a drag is one step of undo, however many rasters it brought") {
    Rig r;
    const Design before = r.document().design;
    r.play("drag \"Picture rotation\":0.5 \"Picture rotation\":0.75 12\nframes 40\nwait\nframes 5");
    CHECK(r.layer().source->rotation == doctest::Approx(90).epsilon(0.1));
    const double turned = r.layer().source->rotation * std::numbers::pi / 180;
    CHECK(r.mean().x == doctest::Approx(-0.5 * std::sin(turned)).epsilon(0.03));
    CHECK(r.document().history.current() == r.document().design);
    r.play("key Ctrl+Z\nframes 5");
    CHECK(r.document().design == before);
}

TEST_CASE("layer source: Escape takes a drag back, and nothing of it comes later") {
    Rig r;
    const Design before = r.document().design;
    r.play(
        "move \"Smoothing\":0.2\ndown left\nmove \"Smoothing\":0.6\nframes 2\nkey Escape\nup left\nframes 2");
    r.designer().remake.wait();
    r.play("frames 3\nwait\nframes 3");
    CHECK(r.document().design == before);
    CHECK(!r.designer().layers.remake);
}

TEST_CASE("layer source: undo takes back a change that is still being made") {
    Rig r;
    const Design before = r.document().design;
    r.designer().layers.remake = ui::LayersView::Remake{1, *r.layer().source};
    r.designer().layers.remake->source.flip = true;
    r.stage.frame(false);
    CHECK(r.designer().remake.busy());
    r.play("key Ctrl+Z");
    r.designer().remake.wait();
    r.play("frames 5");
    CHECK(!r.designer().remake.busy());
    CHECK(r.document().design == before);
}

TEST_CASE("layer source: painting and carrying end it, undo brings it back") {
    for (const char* stroke : {"click \"Paint\"\nclick \"Canvas\":@10,0\n",
                               "click \"Grab\"\ndrag \"Canvas\":@30,90 \"Canvas\":@20,0\n"}) {
        CAPTURE(stroke);
        Rig r;
        const Design before = r.document().design;
        r.play("click \"Layer 1 enabled\"\nframes 3\n" + std::string(stroke) + "frames 30");
        CHECK(!r.layer().source);
        r.play("key Ctrl+Z\nkey Ctrl+Z\nframes 3");
        CHECK(r.document().design == before);
    }
}

TEST_CASE("layer source: another kind of lobe has none") {
    Rig r;
    r.play("click \"Lobe\"\nframes 2\nclick \"Lobe GGX\"\nframes 5");
    CHECK(!r.layer().source);
}

TEST_CASE("layer source: it comes back with the design, and the picture is looked for where that lies") {
    Rig r;
    save_design(r.document().design, r.folder / "a.nacre");
    const std::string text = test::read_all(r.folder / "a.nacre");
    CHECK(text.find("\"nacre\": 2") != text.npos);
    CHECK(text.find(
              "\"source\": {\"image\": \"leaning.exr\", \"as\": \"normals\", \"encoding\": \"signed\"}") !=
          text.npos);
    r.play(r.drop("a.nacre") + "frames 3");
    if (r.designer().files.talking()) r.play("click \"Discard\"\nframes 3");
    REQUIRE(r.layers().size() == 2);
    REQUIRE(r.layer().source);
    CHECK(r.layer().source->image == r.folder / "leaning.exr");
    r.play("click \"Layer 2\"\nclick \"Flip picture\"\nwait\nframes 3");
    CHECK(r.layer().source->flip);
}

TEST_CASE("layer source: a picture that is gone is told, and the layer stays as it is") {
    Rig r;
    fs::remove(r.folder / "leaning.exr");
    const Design before = r.document().design;
    r.play("click \"Down (DirectX)\"\nwait\nframes 3");
    REQUIRE(r.designer().layers.source_trouble);
    CHECK(r.designer().layers.source_trouble->words.starts_with(
        "\u201cleaning.exr\u201d cannot be used. No such file or directory."));
    CHECK(r.document().design == before);
    CHECK(!r.designer().remake.busy());
    // It is there again.
    write_leaning(r.folder / "leaning.exr");
    r.play("click \"Down (DirectX)\"\nwait\nframes 3");
    CHECK(!r.designer().layers.source_trouble);
    CHECK(r.lean() == doctest::Approx(-30).epsilon(0.02));
}

TEST_CASE("layer source: the picture is read again where it has changed") {
    Rig r;
    std::vector<float> flat;
    for (int i = 0; i < 16; ++i) flat.insert(flat.end(), {0.0f, 0.0f, 1.0f});
    write_image(r.folder / "leaning.exr", {4, 4}, flat);
    r.play("click \"Read picture again\"\nwait\nframes 3");
    CHECK(std::abs(r.lean()) < 0.5);
}

TEST_CASE("layer source: no output replaces the picture that a layer was made from") {
    Rig r;
    const std::string before = test::read_all(r.folder / "leaning.exr");
    r.play("key Ctrl+Shift+S\nframes 3\nkey Ctrl+A\ntext \"" + (r.folder / "leaning.exr").string() +
           "\"\nkey Enter\nframes 5");
    CHECK(test::read_all(r.folder / "leaning.exr") == before);
}
