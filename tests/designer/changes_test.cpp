// Files that another program changes, or that an output would change, while the designer has them.
#include <doctest/doctest.h>

#include <fstream>
#include <tuple>

#include "core/design/design_file.h"
#include "core/exchange/image_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::read_all;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;
namespace fs = std::filesystem;

namespace {

void write_grey(const fs::path& file, float value, int side = 8) {
    write_image(file, {side, side}, std::vector<float>(static_cast<std::size_t>(side * side * 3), value));
}

Design named(const char* name) {
    Design design = starter_design();
    design.name = name;
    return design;
}

// A design with the picture paper.exr as its second layer, and the first modulated by spots.exr.
void write_pictured(const TemporaryFolder& folder) {
    write_grey(folder / "paper.exr", 0.5f);
    write_grey(folder / "spots.exr", 0.25f);
    write_all(
        folder / "mine.nacre",
        "{\"nacre\": 1, \"name\": \"Mine\", \"distribution\": {\"layers\": [{\"lobe\": \"gaussian\", "
        "\"modulation\": {\"image\": \"spots.exr\"}}, {\"lobe\": \"painted\", \"image\": \"paper.exr\"}]}}");
}

struct Rig : test::Rig {
    explicit Rig(const fs::path& file) {
        if (!file.empty()) open_at_start(designer(), file);
        play("frames 2");
    }
    void rename(const char* name) {
        document().design.name = name;
        play("frames 2");
    }
    bool asks(const char* button) { return stage.items().rectangle(button).has_value(); }
    float first_texel(std::size_t layer) {
        const Layer& l = layers().at(layer);
        const auto* painted = std::get_if<PaintedLobe>(&l.lobe);
        return (painted ? painted->image : l.modulation->image).raster->values.at(0);
    }
};

struct Saved : TemporaryFolder {
    fs::path file = *this / "mine.nacre";
    Saved() { save_design(named("Mine"), file); }
};

}  // namespace

TEST_CASE("changed design: saving asks before it overwrites, and Escape leaves both as they are") {
    const Saved folder;
    Rig r(folder.file);
    r.rename("Edited");
    save_design(named("Theirs"), folder.file);
    const std::string theirs = read_all(folder.file);
    r.play("key Ctrl+S\nframes 3");
    CHECK(r.asks("Overwrite"));
    r.play("key Escape\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(read_all(folder.file) == theirs);
    CHECK(r.document().design.name == "Edited");
    CHECK(r.document().unsaved());
}

TEST_CASE("changed design: Reload takes what the file holds, and Undo brings one's own back") {
    const Saved folder;
    Rig r(folder.file);
    r.rename("Edited");
    save_design(named("Theirs"), folder.file);
    r.play("key Ctrl+S\nframes 3\nclick \"Reload\"\nframes 3");
    CHECK(r.document().design.name == "Theirs");
    CHECK(!r.document().unsaved());
    r.play("key Ctrl+S\nframes 3");
    CHECK(!talking(r.designer()));  // it is known now
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design.name == "Edited");
    CHECK(r.document().unsaved());
}

TEST_CASE("changed design: Overwrite writes one's own, unless it has changed once more") {
    const Saved folder;
    Rig r(folder.file);
    r.rename("Edited");
    save_design(named("Theirs"), folder.file);
    r.play("key Ctrl+S\nframes 3");
    save_design(named("Later"), folder.file);
    r.play("click \"Overwrite\"\nframes 3");
    CHECK(load_design(folder.file).name == "Later");
    CHECK(r.asks("Overwrite"));
    r.play("frames 30\nclick \"Overwrite\"\nframes 3");
    CHECK(load_design(folder.file).name == "Edited");
    CHECK(!r.document().unsaved());
    r.rename("Again");
    r.play("key Ctrl+S\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(load_design(folder.file).name == "Again");
}

TEST_CASE("changed design: Save as goes to another file and leaves the changed one") {
    const Saved folder;
    Rig r(folder.file);
    r.rename("Edited");
    save_design(named("Theirs"), folder.file);
    r.play("key Ctrl+S\nframes 3\nclick \"Save as\u2026\"\nframes 3\nkey Ctrl+A\ntext \"" +
           (folder / "other.nacre").string() + "\"\nkey Enter\nframes 3");
    CHECK(load_design(folder.file).name == "Theirs");
    CHECK(load_design(folder / "other.nacre").name == "Edited");
    CHECK(r.document().file == folder / "other.nacre");
}

TEST_CASE("changed design: the question comes before work is lost by quitting too") {
    const Saved folder;
    Rig r(folder.file);
    r.rename("Edited");
    save_design(named("Theirs"), folder.file);
    r.play("key Ctrl+Q\nframes 3\nclick \"Save\"\nframes 3");
    CHECK(r.asks("Overwrite"));
    CHECK(!r.designer().files.may_quit());
    r.play("frames 30\nclick \"Cancel\"\nframes 3");
    CHECK(!r.designer().files.may_quit());
    CHECK(load_design(folder.file).name == "Theirs");
}

TEST_CASE("changed design: noticed when the window gets the focus, and asked about once") {
    const Saved folder;
    Rig r(folder.file);
    r.play("focus");
    CHECK(!talking(r.designer()));
    save_design(named("Theirs"), folder.file);
    r.play("focus\nframes 3");
    CHECK(r.asks("Reload"));
    r.play("click \"Keep mine\"\nframes 3");
    CHECK(r.document().unsaved());
    r.play("focus\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(load_design(folder.file).name == "Theirs");
    save_design(named("Later"), folder.file);
    r.play("focus\nframes 3\nframes 30\nclick \"Reload\"\nframes 3");
    CHECK(r.document().design.name == "Later");
    CHECK(!r.document().unsaved());
}

TEST_CASE("changed design: after Keep mine a save overwrites what was asked about, and nothing later") {
    const Saved folder;
    Rig r(folder.file);
    save_design(named("Theirs"), folder.file);
    r.play("focus\nframes 3\nkey Escape\nframes 3");
    r.rename("Edited");
    save_design(named("Later"), folder.file);
    r.play("key Ctrl+S\nframes 3");
    CHECK(r.asks("Overwrite"));
    CHECK(load_design(folder.file).name == "Later");
    save_design(named("Theirs"), folder.file);
    r.play("key Escape\nframes 30\nkey Ctrl+S\nframes 3");
    CHECK(load_design(folder.file).name == "Edited");
}

TEST_CASE("changed design: a file that is gone is told, and written again only where that is wanted") {
    const Saved folder;
    Rig r(folder.file);
    fs::remove(folder.file);
    r.play("focus\nframes 3");
    CHECK(!r.asks("Reload"));
    r.play("click \"Keep mine\"\nframes 3");
    CHECK(r.document().unsaved());
    CHECK(!fs::exists(folder.file));
    r.play("focus\nframes 3");
    CHECK(!talking(r.designer()));
    r.play("key Ctrl+S\nframes 3");  // it is known to be gone
    CHECK(load_design(folder.file).name == "Mine");
    fs::remove(folder.file);
    r.play("key Ctrl+S\nframes 3");
    CHECK(r.asks("Save again"));
    r.play("frames 30\nkey Escape\nframes 3");
    CHECK(!fs::exists(folder.file));
}

TEST_CASE("changed design: what cannot be read is told, and the work stays") {
    const Saved folder;
    Rig r(folder.file);
    r.rename("Edited");
    write_all(folder.file, "{ broken");
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3");
    CHECK(r.designer().files.problem().find("mine.nacre") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3");
    CHECK(r.document().design.name == "Edited");
    CHECK(read_all(folder.file) == "{ broken");
}

TEST_CASE("changed pictures: one question names them all, and Reload is one step of undo") {
    const TemporaryFolder folder;
    write_pictured(folder);
    Rig r(folder / "mine.nacre");
    const Design before = r.document().design;
    CHECK(r.first_texel(1) == 0.5f);
    r.play("focus");
    CHECK(!talking(r.designer()));
    write_grey(folder / "paper.exr", 0.75f);
    write_grey(folder / "spots.exr", 0.125f);
    r.play("focus\nframes 3");
    CHECK(r.designer().changed_pictures.talking());
    r.play("click \"Reload\"\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(r.first_texel(0) == 0.125f);
    CHECK(r.first_texel(1) == 0.75f);
    r.play("focus\nframes 3");
    CHECK(!talking(r.designer()));
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == before);
}

TEST_CASE("changed pictures: asked about after the design, each question by a key of its own") {
    const TemporaryFolder folder;
    write_pictured(folder);
    Rig r(folder / "mine.nacre");
    write_grey(folder / "paper.exr", 0.75f);
    std::ofstream(folder / "mine.nacre", std::ios::app) << "\n";
    r.play("focus\nframes 3");
    CHECK(r.designer().files.talking());
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().files.talking());
    CHECK(r.asks("Reload"));
    r.play("key Enter\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(r.first_texel(1) == 0.75f);
}

TEST_CASE("changed pictures: what is kept is not asked about until it changes once more") {
    const TemporaryFolder folder;
    write_pictured(folder);
    Rig r(folder / "mine.nacre");
    write_grey(folder / "paper.exr", 0.75f);
    r.play("focus\nframes 3\nclick \"Keep mine\"\nframes 3\nfocus\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(r.first_texel(1) == 0.5f);
    write_grey(folder / "paper.exr", 1);
    r.play("focus\nframes 3\nframes 30\nclick \"Reload\"\nframes 3");
    CHECK(r.first_texel(1) == 1);
}

TEST_CASE("changed pictures: one that is gone can be held in the design, which opens without it then") {
    const TemporaryFolder folder;
    write_pictured(folder);
    Rig r(folder / "mine.nacre");
    fs::remove(folder / "paper.exr");
    r.play("focus\nframes 3\nclick \"Hold in design\"\nframes 3\nkey Ctrl+S\nframes 3");
    CHECK(!talking(r.designer()));
    const Design again = load_design(folder / "mine.nacre");
    CHECK(again == r.document().design);
    CHECK(again.distribution.layers.at(0).modulation->image.file == folder / "spots.exr");
}

TEST_CASE("changed pictures: one that cannot be read any more is told, and the old one stays") {
    const TemporaryFolder folder;
    write_pictured(folder);
    Rig r(folder / "mine.nacre");
    const Design before = r.document().design;
    write_all(folder / "paper.exr", "no picture");
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3");
    CHECK(r.designer().changed_pictures.problem().find("paper.exr") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3");
    CHECK(r.document().design == before);
    CHECK(!talking(r.designer()));
}

TEST_CASE("changed surroundings and objects offer to reload") {
    const TemporaryFolder folder;
    write_image(folder / "sky.exr", {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
    write_all(folder / "thing.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Rig r{fs::path()};
    r.designer().environment.want((folder / "sky.exr").string());
    r.play("drop \"" + (folder / "thing.obj").string() + "\"\nwait");
    const Scene before = r.designer().scene;
    REQUIRE(before.environment.picture);
    REQUIRE(before.object.mesh);
    write_image(folder / "sky.exr", {16, 8}, std::vector<float>(16 * 8 * 3, 0.75f));
    write_all(folder / "thing.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3\nwait");
    CHECK(r.designer().scene.environment.picture != before.environment.picture);
    CHECK(r.designer().scene.object.mesh != before.object.mesh);
    r.play("focus\nframes 3");
    CHECK(!talking(r.designer()));
}

TEST_CASE("started with a file that cannot be read: the window says why, over a new design") {
    const TemporaryFolder folder;
    write_all(folder / "broken.nacre", "{ broken");
    write_all(
        folder / "pictured.nacre",
        "{\"nacre\": 1, \"distribution\": {\"layers\": [{\"lobe\": \"painted\", \"image\": \"gone.png\"}]}}");
    for (const char* name : {"broken.nacre", "pictured.nacre", "missing.nacre", "."}) {
        CAPTURE(name);
        Rig r(folder / name);
        const std::string problem = r.designer().files.problem();
        CHECK(problem.find(folder.path().string()) != std::string::npos);
        CHECK(problem.find('\n') == std::string::npos);
        CHECK(r.document().design == starter_design());
        CHECK(r.document().file.empty());
        r.play("frames 30\nkey Enter\nframes 3");
        CHECK(!talking(r.designer()));
    }
}

TEST_CASE("an output is none of the files that the work came from, whatever it is called") {
    const TemporaryFolder folder;
    write_pictured(folder);
    write_image(folder / "sky.exr", {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
    Rig r(folder / "mine.nacre");
    r.designer().environment.want((folder / "sky.exr").string());
    r.play("wait");
    r.designer().plots.state.open = true;
    r.play("wait\nframes 20");
    fs::create_symlink("paper.exr", folder / "link.nacre");
    fs::create_hard_link(folder / "mine.nacre", folder / "hard.svg");
    fs::create_symlink("mine.nacre", folder / "soft.glsl");
    const std::string paper = read_all(folder / "paper.exr"), mine = read_all(folder / "mine.nacre"),
                      sky = read_all(folder / "sky.exr");
    const auto type = [&](const char* name) {
        r.play("key Ctrl+A\ntext \"" + (folder / name).string() + "\"\nkey Enter\nframes 5");
    };
    r.play("key Ctrl+Shift+S\nframes 3");
    type("link.nacre");
    CHECK(r.designer().files.problem().find("paper.exr") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3\nclick \"Save plot\"\nframes 3");
    type("hard.svg");
    r.play("frames 30\nkey Enter\nframes 3");
    CHECK(r.designer().plots.saving.problem().find("mine.nacre") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3");
    // GLSL over the design by another name, and the preview over the surroundings.
    for (const auto& [format, name, input] :
         {std::tuple(1u, "soft.glsl", "mine.nacre"), std::tuple(3u, "sky.exr", "sky.exr")}) {
        r.play("key Ctrl+E\nframes 3");
        r.designer().exporter.options().chosen = format;
        r.play("frames 2\nclick \"Choose export file\"\nframes 3");
        type(name);
        CHECK(r.designer().exporter.problem().find(input) != std::string::npos);
        r.play("frames 30\nkey Enter\nframes 3");
    }
    CHECK(!talking(r.designer()));
    CHECK(read_all(folder / "paper.exr") == paper);
    CHECK(read_all(folder / "mine.nacre") == mine);
    CHECK(read_all(folder / "sky.exr") == sky);
}
