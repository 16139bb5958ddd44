// Unsaved work of a program that has ended.
#include "app/designer/recovery.h"

#include <doctest/doctest.h>

#include <chrono>
#include <set>

#include "core/design/design_file.h"
#include "tests/designer/kept_work.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

TEST_CASE("recovery: discarded work is gone, later keeps it, damaged work is told") {
    const TemporaryFolder folder;
    const fs::path unsaved = folder / "state/nacre/unsaved";
    fs::create_directories(unsaved / "1-0000000a");
    write_autosave({starter_design(), {}, {}}, unsaved / "1-0000000a" / autosave_name);
    fs::create_directories(unsaved / "2-0000000b");
    write_all(unsaved / "2-0000000b" / autosave_name, "{\"nacre_autosave\": 1}\n{\"nacre\"");
    fs::last_write_time(
        unsaved / "1-0000000a" / autosave_name,
        fs::last_write_time(unsaved / "2-0000000b" / autosave_name) - std::chrono::minutes(1));
    fs::create_directories(unsaved / "3-0000000c");  // nothing was kept
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        CHECK(r.designer().recovery.count() == 2);
        CHECK(!fs::exists(unsaved / "3-0000000c"));
        r.play("frames 3\nkey Escape\nframes 3");
        CHECK(!r.designer().recovery.talking());
    }
    Rig r({.bake_threads = 1, .folders = below(folder)});
    CHECK(r.designer().recovery.count() == 2);
    r.play("frames 3\nclick \"Lost work 1\"\nclick \"Restore\"\nframes 3");
    CHECK(r.designer().recovery.talking());  // the newest is the damaged one
    CHECK(r.document().design == starter_design());
    r.play("frames 30\nclick \"Discard\"\nframes 30\nclick \"Discard\"\nframes 3");
    CHECK(fs::is_empty(unsaved));
    CHECK(!r.designer().recovery.talking());
}

TEST_CASE("recovery: whatever this program did not write into the folder is left as it is") {
    const TemporaryFolder folder;
    const fs::path unsaved = folder / "state/nacre/unsaved";
    const std::vector<std::string> foreign = {"letter.txt",
                                              "somebody-elses-work/letter.txt",
                                              "12-0000000g/lock",
                                              "1234/lock",
                                              "x-00000000/unsaved.nacre",
                                              "7-00000007/letter.txt",
                                              "8-00000008/lock/deep.txt",
                                              "9-00000009/lock",
                                              "10-0000000a/unsaved.nacre/deep.txt"};
    for (const std::string& name : foreign) {
        fs::create_directories((unsaved / name).parent_path());
        write_all(unsaved / name, "mine");
    }
    fs::create_directories(folder / "elsewhere");
    write_autosave({starter_design(), {}, {}}, folder / "elsewhere" / autosave_name);
    fs::create_directory_symlink(folder / "elsewhere", unsaved / "11-0000000b");
    fs::create_directory(unsaved / "12-0000000c");
    fs::create_symlink(folder / "elsewhere" / autosave_name, unsaved / "12-0000000c" / autosave_name);
    const auto names = [&](const fs::path& below) {
        std::set<std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(below)) all.insert(entry.path().string());
        return all;
    };
    const auto before = names(folder.path());
    const std::string elsewhere = read_all(folder / "elsewhere" / autosave_name);
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        CHECK(r.designer().recovery.count() == 0);
        finish(r.designer());
    }
    CHECK(names(folder.path()) == before);
    for (const std::string& name : foreign) CHECK(read_all(unsaved / name) == "mine");
    CHECK(read_all(folder / "elsewhere" / autosave_name) == elsewhere);
}

TEST_CASE(
    "recovery: a folder of ours keeps what somebody put into it when its work is restored or discarded") {
    const TemporaryFolder folder;
    const fs::path unsaved = folder / "state/nacre/unsaved";
    for (const char* name : {"1-0000000a", "2-0000000b"}) {
        fs::create_directories(unsaved / name);
        write_autosave({starter_design(), {}, {}}, unsaved / name / autosave_name);
        write_all(unsaved / name / "letter.txt", "mine");
        write_all(unsaved / name / ".nacre-4711-0123456789abcdef", "cut off");
    }
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        CHECK(r.designer().recovery.count() == 2);
        r.play("frames 3\nclick \"Discard\"\nframes 30\nclick \"Restore\"\nframes 3");
        r.designer().autosave.wait();
        finish(r.designer());
    }
    for (const char* name : {"1-0000000a", "2-0000000b"}) {
        CHECK(read_all(unsaved / name / "letter.txt") == "mine");
        CHECK(std::distance(fs::directory_iterator(unsaved / name), {}) == 1);
    }
}

TEST_CASE("recovery: a first line that leads astray is told, and nothing is written through it") {
    const TemporaryFolder folder;
    write_all(folder / "letter", "mine");
    const fs::path file = folder / "state/nacre/unsaved/1-0000000a" / autosave_name;
    fs::create_directories(file.parent_path());
    const std::string letter = (folder / "letter").string();
    for (const std::string& head :
         {"\"file\": \"" + letter + "\\u0000.nacre\"", std::string("\"file\": \"letter\""),
          std::string("\"file\": 7"), "\"file\": \"" + letter + "\", \"held\": \"4-\"",
          "\"pictures\": [{\"at\": \"a\", \"file\": \"" + letter + "\\u0000\"}]"}) {
        CAPTURE(head);
        write_all(file, "{\"nacre_autosave\": 2, \"name\": \"x\", " + head + "}\n" +
                            design_json(starter_design(), folder.path()));
        Rig r({.bake_threads = 1, .folders = below(folder)});
        REQUIRE(r.designer().recovery.count() == 1);
        r.play("frames 3\nclick \"Restore\"\nframes 3");
        CHECK(r.designer().recovery.talking());
        CHECK(r.document().file.empty());
    }
    CHECK(read_all(folder / "letter") == "mine");
}

TEST_CASE("recovery: restored work asks before it overwrites a file that has changed since") {
    const TemporaryFolder folder;
    const fs::path file = folder / "mine.nacre";
    save_design(starter_design(), file);
    UnsavedWork work{starter_design(), file, {{file, *content_of_file(file)}}};
    work.design.name = "Edited";
    fs::create_directories(folder / "state/nacre/unsaved/1-0000000a");
    write_autosave(work, folder / "state/nacre/unsaved/1-0000000a" / autosave_name);
    Design theirs = starter_design();
    theirs.name = "Theirs";
    save_design(theirs, file);
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.play("frames 3\nkey Enter\nframes 3");
    REQUIRE(r.frames_until([&] { return r.designer().files.talking(); }));  // noticed at once
    r.play("frames 30\nkey Escape\nframes 3");
    CHECK(r.document().design == work.design);
    CHECK(r.document().unsaved());
    CHECK(load_design(file) == theirs);
}

TEST_CASE("recovery: work that is in its file already counts as saved") {
    const TemporaryFolder folder;
    const fs::path file = folder / "mine.nacre";
    save_design(starter_design(), file);
    fs::create_directories(folder / "state/nacre/unsaved/1-0000000a");
    write_autosave({starter_design(), file, {}}, folder / "state/nacre/unsaved/1-0000000a" / autosave_name);
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.play("frames 3\nkey Enter\nframes 3");
    CHECK(r.document().file == file);
    CHECK(!r.document().unsaved());
    r.designer().autosave.wait();
    CHECK(!fs::exists(folder / "state/nacre/unsaved/1-0000000a"));
}
