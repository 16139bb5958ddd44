// What is said of pictures that are read, where the user looks.
#include "app/designer/picture_notes.h"

#include <doctest/doctest.h>

#include "core/image/image_file.h"
#include "tests/designer/folder_rig.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

constexpr const char* wide_note = "8 x 2 pixels, made square with black beside it";
constexpr const char* large_note = "1200 x 1200 pixels, averaged down to 1024 x 1024";

std::vector<float> grey(int pixels) { return std::vector<float>(static_cast<std::size_t>(pixels) * 3, 0.5f); }

struct NotesRig : FolderRig {
    NotesRig() {
        designer().layers.expert = false;  // else the mask's buttons lie below the panel's end
        write_image(folder / "wide.exr", {8, 2}, grey(16));
        write_image(folder / "large.exr", {1200, 1200}, grey(1200 * 1200));
    }
    bool shows(const char* text) { return stage.items().rectangle(text).has_value(); }
    const std::string& message() { return designer().files.message(); }
};

}  // namespace

TEST_CASE("picture notes: one line, each file once") {
    CHECK(notes_line("/a/b.png", {}).empty());
    CHECK(notes_line("/a/b.png", {"one", "two"}) == "b.png: one; two");
    Design design;
    design.distribution.layers = {Layer{}, Layer{}, Layer{}, Layer{}};
    design.distribution.layers[0].lobe = PaintedLobe{{"/a/b.png", {}, {"one"}}};
    design.distribution.layers[1].lobe = PaintedLobe{{"/a/b.png", {}, {"one"}}};
    design.distribution.layers[2].modulation = Modulation{{"/c/b.png", {}, {"two"}}, 1};
    design.distribution.layers[3].modulation = Modulation{{{}, {}, {"held in the design"}}, 1};
    CHECK(notes_line(design) == "b.png: one; b.png: two");
}

TEST_CASE("picture notes: a stamp, heights and a modulation tell theirs, the last one below its name too") {
    NotesRig r;
    r.play(r.drop("wide.exr") + r.import("Stamp"));
    CHECK(r.message() == std::string("wide.exr: ") + wide_note);
    r.designer().files.tell("");
    r.play("click \"Layer 1\"\n" + r.drop("wide.exr") + r.import("Modulation"));
    CHECK(r.message() == std::string("wide.exr: ") + wide_note);
    CHECK(r.shows(wide_note));
    r.play("click \"Remove modulation\"\nframes 3");
    CHECK(!r.shows(wide_note));
    // Square, and small enough.
    write_image(r.folder / "small.exr", {8, 8}, grey(64));
    r.designer().files.tell("before");
    r.play(r.drop("small.exr") + r.import("Modulation"));
    CHECK(r.message() == "before");
}

TEST_CASE("picture notes: a design's pictures tell theirs when it opens, until they are painted over") {
    NotesRig r;
    write_all(r.folder / "a.nacre",
              "{\"nacre\": 1, \"distribution\": {\"layers\": [{\"lobe\": \"painted\", \"image\": "
              "\"large.exr\"}]}}");
    const Design before = r.document().design;
    r.play(r.drop("a.nacre") + "wait\nframes 3");
    CHECK(r.message() == std::string("Opened a.nacre; large.exr: ") + large_note);
    CHECK(r.shows(large_note));
    r.canvas().tool = ui::CanvasTool::paint;
    r.play("click \"Canvas\":@20,0\nframes 3");
    CHECK(!r.shows(large_note));
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.shows(large_note));
    write_image(r.folder / "large.exr", {8, 8}, grey(64));
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3");
    CHECK(!r.shows(large_note));
}

TEST_CASE("picture notes: an environment map tells its own below its choice") {
    NotesRig r;
    std::vector<float> rgb = grey(16 * 8);
    rgb[7] = -0.5f;
    write_image(r.folder / "sky.exr", {16, 8}, rgb);
    r.play(r.drop("sky.exr") + r.import("Environment map") + "click \"Light\"\nframes 3");
    const auto note = r.stage.items().rectangle("1 of 128 pixels are below 0, down to -0.5, and count as 0");
    REQUIRE(note);
    CHECK(note->y > r.stage.items().rectangle("Environment")->w);
    CHECK(note->w <= r.stage.items().rectangle("Environment rotation")->y);
}
