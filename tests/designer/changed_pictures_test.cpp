// Pictures, environment maps and objects that another program changes while they are shown.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/designer/changed_files.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

struct PictureRig : FileRig {
    using FileRig::FileRig;
    float first_texel(std::size_t layer) {
        const Layer& l = layers().at(layer);
        const auto* painted = std::get_if<PaintedLobe>(&l.lobe);
        return (painted ? painted->image : l.modulation->image).raster->values.at(0);
    }
};

}  // namespace

TEST_CASE("changed pictures: one question names them all, and Reload is one step of undo") {
    const Pictured folder;
    PictureRig r(folder.file);
    const Design before = r.document().design;
    CHECK(r.first_texel(1) == 0.5f);
    r.play("focus");
    CHECK(!talking(r.designer()));
    write_grey(folder / "paper.exr", 0.75f);
    write_grey(folder / "spots.exr", 0.125f);
    r.focus();
    CHECK(r.designer().changed_pictures.talking());
    r.play("click \"Reload\"\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(r.first_texel(0) == 0.125f);
    CHECK(r.first_texel(1) == 0.75f);
    r.focus();
    CHECK(!talking(r.designer()));
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == before);
}

TEST_CASE("changed pictures: asked about after the design, each question by a key of its own") {
    const Pictured folder;
    PictureRig r(folder.file);
    write_grey(folder / "paper.exr", 0.75f);
    std::ofstream(folder / "mine.nacre", std::ios::app) << "\n";
    r.focus();
    CHECK(r.designer().files.talking());
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().files.talking());
    CHECK(r.asks("Reload"));
    r.play("key Enter\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(r.first_texel(1) == 0.75f);
}

TEST_CASE("changed pictures: what is kept is not asked about until it changes once more") {
    const Pictured folder;
    PictureRig r(folder.file);
    write_grey(folder / "paper.exr", 0.75f);
    r.play("focus\nframes 3\nclick \"Keep mine\"\nframes 3\nfocus\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(r.first_texel(1) == 0.5f);
    write_grey(folder / "paper.exr", 1);
    r.play("focus\nframes 3\nframes 30\nclick \"Reload\"\nframes 3");
    CHECK(r.first_texel(1) == 1);
}

TEST_CASE("changed pictures: one that is gone can be held in the design, which opens without it then") {
    const Pictured folder;
    PictureRig r(folder.file);
    fs::remove(folder / "paper.exr");
    r.play("focus\nframes 3\nclick \"Hold in design\"\nframes 3\nkey Ctrl+S\nframes 3");
    CHECK(!talking(r.designer()));
    const Design again = load_design(folder / "mine.nacre");
    CHECK(again == r.document().design);
    CHECK(again.distribution.layers.at(0).modulation->image.file == folder / "spots.exr");
}

TEST_CASE("changed pictures: one that cannot be read any more is told, and the old one stays") {
    const Pictured folder;
    PictureRig r(folder.file);
    const Design before = r.document().design;
    write_all(folder / "paper.exr", "no picture");
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3");
    CHECK(r.designer().changed_pictures.problem().find("paper.exr") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3");
    CHECK(r.document().design == before);
    CHECK(!talking(r.designer()));
}

TEST_CASE("changed environment maps and objects offer to reload") {
    const TemporaryFolder folder;
    write_sky(folder / "sky.exr", 0.5f);
    write_all(folder / "thing.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    PictureRig r{fs::path()};
    r.designer().environment.want((folder / "sky.exr").string());
    r.play("drop \"" + (folder / "thing.obj").string() + "\"\nwait");
    const Scene before = r.designer().scene;
    REQUIRE(before.environment.picture);
    REQUIRE(before.object.mesh);
    write_sky(folder / "sky.exr", 0.75f);
    write_all(folder / "thing.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3\nwait");
    CHECK(r.designer().scene.environment.picture != before.environment.picture);
    CHECK(r.designer().scene.object.mesh != before.object.mesh);
    r.focus();
    CHECK(!talking(r.designer()));
}
