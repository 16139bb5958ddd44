// The wall of presets.
#include "app/designer/preset_wall.h"

#include <doctest/doctest.h>

#include <set>

#include "app/designer/recovery.h"
#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/design/design_file.h"
#include "core/paint/painted_layer.h"
#include "tests/designer/kept_work.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* click_satin = "click \"Presets\"\nframes 2\nclick \"Preset Satin\"\nframes 2\n";

Design satin() { return load_design(presets_folder() / "satin.nacre"); }

struct PresetRig : Rig {
    TemporaryFolder folder;
    Design lacquer;

    PresetRig() {
        lacquer = document().design;
        lacquer.name = "Lacquer";
        save_design(lacquer, folder / "lacquer.nacre");
        open_at_start(designer(), folder / "lacquer.nacre");
        play("frames 2");
        REQUIRE(document().file == folder / "lacquer.nacre");
    }
};

}  // namespace

TEST_CASE("presets: a click begins a new, unnamed document, and one undo brings back the old with its file") {
    PresetRig r;
    r.play(click_satin);
    CHECK(r.document().design == satin());
    CHECK(r.document().file.empty());
    CHECK(!r.document().unsaved());
    CHECK(!r.designer().files.talking());
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.document().design == r.lacquer);
    CHECK(r.document().file == r.folder / "lacquer.nacre");
    CHECK(!r.document().unsaved());
    CHECK(!r.document().held.empty());
    r.play("key Ctrl+Y\nframes 2");
    CHECK(r.document().design == satin());
    CHECK(r.document().file.empty());
}

TEST_CASE("presets: what was not saved before is asked about before it is lost, and can be brought back") {
    PresetRig r;
    r.document().design.name = "Changed";
    r.document().commit();
    r.play(click_satin);
    CHECK(!r.designer().files.talking());
    r.play("key Ctrl+N\nframes 2");
    CHECK(r.designer().files.talking());
    CHECK(r.document().design == satin());
    r.play("click \"Bring back\"\nframes 2");
    CHECK(r.document().design.name == "Changed");
    CHECK(r.document().file == r.folder / "lacquer.nacre");
    CHECK(r.document().unsaved());
    r.play("key Ctrl+Y\nframes 2\nkey Ctrl+N\nframes 2\nclick \"Discard\"\nframes 2");
    CHECK(r.document().design == starter_design());
}

TEST_CASE("presets: one that is pointed at is shown, and leaves no trace") {
    Rig r;
    const Design before = r.document().design;
    r.play("click \"Presets\"\nframes 2\nmove \"Preset Satin\"\nframes 3\nwait");
    CHECK(r.designer().frame.design == satin());
    CHECK(r.document().design == before);
    r.play("move \"Preview\"\nframes 3\nwait");
    CHECK(r.designer().frame.design == before);
    CHECK(!r.document().history.can_undo());
    r.play("move \"Preset Satin\"\nframes 3\nclick \"Layers\"\nframes 3");
    CHECK(r.designer().frame.design == before);
    // Also where the panel goes away beneath the pointer.
    r.play("click \"Presets\"\nframes 2\nmove \"Preset Satin\"\nframes 3");
    CHECK(r.designer().frame.design == satin());
    r.play("key Tab\nframes 3");
    CHECK(r.designer().frame.design == before);
}

TEST_CASE("presets: added as layers, with half as many facets as there were") {
    Rig r;
    const Design before = r.document().design;
    r.play(
        "click \"Presets\"\nframes 2\nmove \"Preset Satin\"\ndown right\nup right\nframes 2\nclick \"Add "
        "preset as layer\"\n"
        "frames 2");
    REQUIRE(r.layers().size() == 1 + satin().distribution.layers.size());
    CHECK(r.layers()[0] == before.distribution.layers[0]);
    CHECK(weight_of_others(r.document().design.distribution, 0) ==
          doctest::Approx(0.5 * before.distribution.layers[0].weight));
    CHECK(r.document().design.fresnel == before.fresnel);
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.document().design == before);
    Distribution full;
    full.layers.resize(limits::layers_max);
    CHECK_THROWS_AS(add_layers(full, satin().distribution, "Satin"), UserError);
    CHECK(full.layers.size() == limits::layers_max);
}

TEST_CASE("presets: unsaved work that a preset took the place of is kept for a restart") {
    const TemporaryFolder folder;
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.document().design.name = "Precious";
    r.document().commit();
    r.play(click_satin);
    r.designer().autosave.wait();
    r.play("frames 2");
    std::string name;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "state/nacre/unsaved"))
        if (entry.path().filename() == autosave_name) name = read_autosave_head(entry.path()).name;
    CHECK(name == "Precious");
}

TEST_CASE("presets: of unsaved work and an edited preset in its place a kill loses neither") {
    const TemporaryFolder folder;
    const fs::path unsaved = folder / "state/nacre/unsaved";
    const auto kept = [&] {
        std::multiset<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(unsaved))
            if (entry.path().filename() == autosave_name)
                names.insert(read_autosave(entry.path()).design.name);
        return names;
    };
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        const auto edit = [&](const char* name) {
            r.document().design.name = name;
            r.play("frames 2");
            r.designer().autosave.wait();
            r.play("frames 2");
            CHECK(r.designer().autosave.problem().empty());
        };
        edit("First");
        r.play(click_satin);
        edit("Second");
        CHECK(kept() == std::multiset<std::string>{"First", "Second"});
        r.play(click_satin);
        edit("Third");
        CHECK(kept() == std::multiset<std::string>{"First", "Second", "Third"});
        edit("Third again");
        CHECK(kept() == std::multiset<std::string>{"First", "Second", "Third again"});
        // Back in the first, whose newest step is what undo has come to; the others are done again by redo.
        while (r.document().history.can_undo() && r.document().design.name != "First") r.document().undo();
        r.play("frames 2");
        r.designer().autosave.wait();
        CHECK(kept() == std::multiset<std::string>{"First", "Second", "Third again"});
        while (r.document().history.can_redo()) r.document().redo();
        r.play("frames 2");
        r.designer().autosave.wait();
    }  // without finish(): as if it had been killed
    CHECK(kept() == std::multiset<std::string>{"First", "Second", "Third again"});
    Rig r({.bake_threads = 1, .folders = below(folder)});
    REQUIRE(r.designer().recovery.count() == 3);
    r.play("frames 3\nclick \"Restore\"\nframes 3");
    const std::string restored = r.document().design.name;
    CHECK(kept().count(restored) == 1);
    CHECK(r.designer().files.message() ==
          "Restored " + restored + "; 2 more under File, Recover unsaved work");
    r.designer().autosave.wait();
    finish(r.designer());  // the restored one is this program's; the others wait for the next start
    CHECK(kept().size() == 2);
    Recovery next(unsaved);
    next.look();
    CHECK(next.count() == 2);
}

TEST_CASE("presets: saving one of several unsaved works removes what was kept of it alone") {
    const TemporaryFolder folder;
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.document().design.name = "First";
    r.play("frames 2");
    r.play(click_satin);
    r.document().design.name = "Second";
    r.play("frames 2");
    r.document().file = folder / "second.nacre";
    r.designer().files.save(r.document());
    r.play("frames 2");
    REQUIRE(fs::exists(folder / "second.nacre"));
    r.designer().autosave.wait();
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "state/nacre/unsaved"))
        if (entry.path().filename() == autosave_name) names.push_back(read_autosave_head(entry.path()).name);
    CHECK(names == std::vector<std::string>{"First"});
    r.play("key Ctrl+Q\nframes 3");
    CHECK(!r.designer().files.may_quit());  // the first is asked about
}
