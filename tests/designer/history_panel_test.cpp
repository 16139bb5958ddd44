// The history: what each step is called, and a click that goes there.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/random_painter.h"
#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::RandomPainter;
using nacre::test::Rig;
using nacre::test::TemporaryFolder;

namespace {

const History& history(Rig& r) { return r.document().history; }

std::vector<std::string> steps(Rig& r) {
    std::vector<std::string> names;
    for (const History::State& state : history(r).states()) names.push_back(state.what);
    return names;
}

const std::string& last(Rig& r) { return history(r).states().back().what; }

}  // namespace

TEST_CASE("history: a step is called by the widget, the tool or the command that made it") {
    Rig r;
    CHECK(steps(r) == std::vector<std::string>{"New design"});
    struct Case {
        const char* script;
        const char* name;
    };
    for (const auto& [script, name] :
         {Case{"drag \"Width x\":0.5 \"Width x\":0.3 5\nframes 30", "Width x"},
          Case{"drag \"Weight\":0.5 \"Weight\":0.3 5\nframes 30", "Weight"},
          Case{"drag \"Tilt\":0.1 \"Tilt\":0.3 5\nframes 30", "Tilt"},
          Case{"move \"Tilt\":0.3\ndown left\nup left\ndown left\nup left\nframes 60", "Tilt"},
          Case{"click \"Layer name\"\nframes 3\ntext \"Sheen\"\nkey Enter\nframes 3", "Layer name"},
          Case{"key Ctrl+D\nframes 3", "Duplicate"},
          Case{"click \"Delete layer\"\nframes 3", "Delete layer"},
          Case{"click \"Add layer\"\nframes 3\nclick \"Add GGX\"\nframes 3", "Add GGX"},
          Case{"click \"Layer 1\" right\nframes 3\nclick \"Menu Duplicate\"\nframes 3", "Duplicate layer"},
          Case{"key 3\nclick \"Layer up\"\nframes 3", "Layer up"},
          Case{"drag \"Layer 1\" \"Layer 3\":0.5,0.9 5\nframes 3", "Move layer"},
          Case{"click \"Layer 2 enabled\"\nframes 3", "Layer 2 enabled"},
          Case{"click \"Lobe\"\nframes 5\nclick \"Lobe Beckmann\"\nframes 5", "Lobe Beckmann"},
          Case{"key B\ndrag \"Canvas\":@10,0 \"Canvas\":@40,90 5\nframes 3", "Paint"},
          Case{"key E\ndrag \"Canvas\":@10,0 \"Canvas\":@40,90 5\nframes 3", "Erase"},
          Case{"key R\ndrag \"Canvas\":@20,0 \"Canvas\":@40,90 5\nframes 3", "Ring"},
          Case{"key B\ndrag \"Preview\":0.5,0.5 \"Preview\":0.6,0.5 5\nframes 3", "Paint"},
          Case{"key G\ndrag \"Canvas\":@5,0 \"Canvas\":@30,90 5\nframes 3", "Grab"},
          Case{"click \"New painted layer\"\nframes 3", "New painted layer"},
          Case{"key Ctrl+X\nframes 3", "Cut"},
          Case{"key Ctrl+V\nframes 3", "Paste"},
          Case{"click \"Material\"\nframes 3\ndrag \"f0 red\":0.5 \"f0 red\":0.3 5\nframes 30", "f0"},
          Case{"click \"Design name\"\nframes 3\ntext \"Satin\"\nkey Enter\nframes 3", "Design name"},
          Case{"click \"Presets\"\nframes 2\nclick \"Preset Satin\"\nframes 3", "Preset Satin"}}) {
        CAPTURE(script);
        const std::size_t before = history(r).states().size();
        r.play(script);
        CHECK(history(r).states().size() == before + 1);
        CHECK(last(r) == name);
    }
}

TEST_CASE("history: two edits within the time of a double click have a name each") {
    Rig r;
    r.play("drag \"Width x\":0.5 \"Width x\":0.3 2\nkey Ctrl+D\nframes 3");
    CHECK(steps(r) == std::vector<std::string>{"New design", "Width x", "Duplicate"});
}

TEST_CASE("history: a command that was found is called by its name, a preset by its own") {
    Rig r;
    r.play("key Ctrl+K\nframes 3\ntext \"duplicate\"\nframes 3\nkey Enter\nframes 5");
    CHECK(last(r) == "Duplicate");
    r.play("key Ctrl+K\nframes 3\ntext \"preset satin\"\nframes 3\nkey Enter\nframes 5");
    CHECK(last(r) == "Preset Satin");
}

TEST_CASE("history: a click goes to a step, those after it stay until something new is done") {
    Rig r;
    const auto row = [](int step) { return "click \"Step " + std::to_string(step) + "\"\nframes 3"; };
    CHECK(!r.stage.items().rectangle("Step 0"));
    r.play("key Ctrl+H\nframes 3");
    CHECK(r.stage.items().rectangle("Step 0"));
    std::vector<Design> designs = {r.document().design};
    for (const char* widget : {"Width x", "Weight", "Softness"}) {
        const std::string name = '"' + std::string(widget) + '"';
        r.play("drag " + name + ":0.5 " + name + ":0.3 3\nframes 30");
        designs.push_back(r.document().design);
    }
    CHECK(steps(r) == std::vector<std::string>{"New design", "Width x", "Weight", "Softness"});
    REQUIRE(history(r).states().size() == 4);
    r.play(row(1));
    CHECK(r.document().design == designs[1]);
    CHECK(history(r).position() == 1);
    CHECK(history(r).states().size() == 4);
    r.play(row(3));
    CHECK(r.document().design == designs[3]);
    r.play(row(0));
    CHECK(r.document().design == designs[0]);
    CHECK(!r.document().unsaved());
    r.play(row(1) + "\ndrag \"Softness\":0.4 \"Softness\":0.8 3\nframes 30");
    CHECK(steps(r) == std::vector<std::string>{"New design", "Width x", "Softness"});
    CHECK(!r.stage.items().rectangle("Step 3"));
    r.play("key Ctrl+H\nframes 3");
    CHECK(!r.stage.items().rectangle("Step 0"));
}

TEST_CASE("history: a click across a preset brings back the document with its file") {
    const TemporaryFolder folder;
    save_design(starter_design(), folder / "mine.nacre");
    Rig r;
    r.document() = read_document(folder / "mine.nacre");
    CHECK(steps(r) == std::vector<std::string>{"Open mine.nacre"});
    r.play(
        "click \"Presets\"\nframes 2\nclick \"Preset Satin\"\nframes 3\nclick "
        "\"Preset Copper\"\nframes 3");
    CHECK(r.document().file.empty());
    r.play("key Ctrl+H\nframes 3\nclick \"Step 0\"\nframes 3");
    CHECK(r.document().file == folder / "mine.nacre");
    CHECK(r.document().design == starter_design());
    r.play("click \"Step 2\"\nframes 3");
    CHECK(r.document().design.name == "Copper");
    CHECK(r.document().file.empty());
}

TEST_CASE("history: no step is left without a name of its own, whatever is done") {
    Rig r;
    RandomPainter painter(7, {"/nowhere.png"});
    for (int i = 0; i < 150; ++i) {
        r.play("key Escape\nframes 1");
        for (const std::string& line : painter.act()) {
            try {
                r.play(line);
            } catch (const std::exception&) {
                break;  // a widget that is not on the screen
            }
        }
    }
    r.play("frames 60");
    REQUIRE(history(r).states().size() > 20);
    for (const std::string& name : steps(r)) {
        CHECK(!name.empty());
        CHECK(name != "Edit");
        CHECK(name != "Canvas");
        CHECK(name != "Preview");
        CHECK(name != "Undo");
        CHECK(name != "Redo");
    }
}
