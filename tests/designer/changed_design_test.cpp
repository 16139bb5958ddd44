// A design that another program changes while it is open here.
#include <doctest/doctest.h>

#include "tests/designer/changed_files.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

Design named(const char* name) {
    Design design = starter_design();
    design.name = name;
    return design;
}

struct Saved {
    TemporaryFolder folder;
    fs::path file = folder / "mine.nacre";
    Saved() { save_design(named("Mine"), file); }
};

struct Opened : Saved, FileRig {
    Opened() : FileRig(file) {}
    void rename(const char* name) {
        document().design.name = name;
        play("frames 2");
    }
};

// Changed here first, and then by another program.
struct Edited : Opened {
    Edited() {
        rename("Edited");
        save_design(named("Theirs"), file);
    }
};

}  // namespace

TEST_CASE("changed design: saving asks before it overwrites, and Escape leaves both as they are") {
    Edited r;
    const std::string theirs = read_all(r.file);
    r.play("key Ctrl+S\nframes 3");
    CHECK(r.asks("Overwrite"));
    r.play("key Escape\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(read_all(r.file) == theirs);
    CHECK(r.document().design.name == "Edited");
    CHECK(r.document().unsaved());
}

TEST_CASE("changed design: Reload takes what the file holds, and Undo brings one's own back") {
    Edited r;
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
    Edited r;
    r.play("key Ctrl+S\nframes 3");
    save_design(named("Later"), r.file);
    r.play("click \"Overwrite\"\nframes 3");
    CHECK(load_design(r.file).name == "Later");
    CHECK(r.asks("Overwrite"));
    r.play("frames 30\nclick \"Overwrite\"\nframes 3");
    CHECK(load_design(r.file).name == "Edited");
    CHECK(!r.document().unsaved());
    r.rename("Again");
    r.play("key Ctrl+S\nframes 3");
    CHECK(!talking(r.designer()));
    CHECK(load_design(r.file).name == "Again");
}

TEST_CASE("changed design: Save as goes to another file and leaves the changed one") {
    Edited r;
    r.play("key Ctrl+S\nframes 3\nclick \"Save as\u2026\"\nframes 3\nkey Ctrl+A\ntext \"" +
           (r.folder / "other.nacre").string() + "\"\nkey Enter\nframes 3");
    CHECK(load_design(r.file).name == "Theirs");
    CHECK(load_design(r.folder / "other.nacre").name == "Edited");
    CHECK(r.document().file == r.folder / "other.nacre");
}

TEST_CASE("changed design: the question comes before work is lost by quitting too") {
    Edited r;
    r.play("key Ctrl+Q\nframes 3\nclick \"Save\"\nframes 3");
    CHECK(r.asks("Overwrite"));
    CHECK(!r.designer().files.may_quit());
    r.play("frames 30\nclick \"Cancel\"\nframes 3");
    CHECK(!r.designer().files.may_quit());
    CHECK(load_design(r.file).name == "Theirs");
}

TEST_CASE("changed design: noticed when the window gets the focus, and asked about once") {
    Opened r;
    r.play("focus");
    CHECK(!talking(r.designer()));
    save_design(named("Theirs"), r.file);
    r.focus();
    CHECK(r.asks("Reload"));
    r.play("click \"Keep mine\"\nframes 3");
    CHECK(r.document().unsaved());
    r.focus();
    CHECK(!talking(r.designer()));
    CHECK(load_design(r.file).name == "Theirs");
    save_design(named("Later"), r.file);
    r.play("focus\nframes 3\nframes 30\nclick \"Reload\"\nframes 3");
    CHECK(r.document().design.name == "Later");
    CHECK(!r.document().unsaved());
}

TEST_CASE("changed design: after Keep mine a save overwrites what was asked about, and nothing later") {
    Opened r;
    save_design(named("Theirs"), r.file);
    r.play("focus\nframes 3\nkey Escape\nframes 3");
    r.rename("Edited");
    save_design(named("Later"), r.file);
    r.play("key Ctrl+S\nframes 3");
    CHECK(r.asks("Overwrite"));
    CHECK(load_design(r.file).name == "Later");
    save_design(named("Theirs"), r.file);
    r.play("key Escape\nframes 30\nkey Ctrl+S\nframes 3");
    CHECK(load_design(r.file).name == "Edited");
}

TEST_CASE("changed design: a file that is gone is told, and written again only where that is wanted") {
    Opened r;
    fs::remove(r.file);
    r.focus();
    CHECK(!r.asks("Reload"));
    r.play("click \"Keep mine\"\nframes 3");
    CHECK(r.document().unsaved());
    CHECK(!fs::exists(r.file));
    r.focus();
    CHECK(!talking(r.designer()));
    r.play("key Ctrl+S\nframes 3");  // it is known to be gone
    CHECK(load_design(r.file).name == "Mine");
    fs::remove(r.file);
    r.play("key Ctrl+S\nframes 3");
    CHECK(r.asks("Save again"));
    r.play("frames 30\nkey Escape\nframes 3");
    CHECK(!fs::exists(r.file));
}

TEST_CASE("changed design: what cannot be read is told, and the work stays") {
    Opened r;
    r.rename("Edited");
    write_all(r.file, "{ broken");
    r.play("focus\nframes 3\nclick \"Reload\"\nframes 3");
    CHECK(r.designer().files.problem().find("mine.nacre") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3");
    CHECK(r.document().design.name == "Edited");
    CHECK(read_all(r.file) == "{ broken");
}
