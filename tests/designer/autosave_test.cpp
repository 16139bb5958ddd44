// Unsaved work on the disk, while its program runs.
#include "app/designer/autosave.h"

#include <doctest/doctest.h>

#include <fstream>

#include "app/designer/recovery.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "tests/designer/kept_work.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

TEST_CASE("autosave: what is written is read again, wherever its pictures lie") {
    const TemporaryFolder folder;
    UnsavedWork work{painted_document().design, "/some/where/\u00e4.nacre", {}};
    work.design.name = "Line\nbreak";
    write_autosave(work, folder / "unsaved.nacre");
    CHECK(read_autosave(folder / "unsaved.nacre") == work);
    CHECK(read_autosave_head(folder / "unsaved.nacre").name == work.design.name);
}

TEST_CASE("autosave: follows each step, goes when all is saved, and stays where the program is killed") {
    const TemporaryFolder folder;
    const fs::path unsaved = folder / "state/nacre/unsaved";
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        CHECK(!fs::exists(unsaved));
        r.play("drag \"Width x\":0.5 \"Width x\":0.3 5");
        r.designer().autosave.wait();
        r.play("frames 1");
        CHECK(r.designer().autosave.problem().empty());
        CHECK(claim_abandoned(unsaved).empty());  // its owner lives
        r.play("key Ctrl+Z");
        r.designer().autosave.wait();
        CHECK(std::distance(fs::recursive_directory_iterator(unsaved), {}) == 2);  // the folder and its lock
        r.play("key Ctrl+Y");
        r.designer().autosave.wait();
    }  // without finish(): as if it had been killed
    REQUIRE(fs::exists(unsaved));
    Rig r({.bake_threads = 1, .folders = below(folder)});
    CHECK(r.designer().recovery.count() == 1);
    Recovery second(unsaved);
    second.look();
    CHECK(second.count() == 0);  // one window offers it
    r.play("frames 3\nclick \"Restore\"\nframes 3");
    CHECK(r.document().unsaved());
    CHECK(r.document().design != starter_design());
    CHECK(r.document().file.empty());
    CHECK(!r.designer().recovery.talking());
    r.designer().autosave.wait();
    finish(r.designer());
    CHECK(fs::is_empty(unsaved));
}

TEST_CASE(
    "autosave: restored without the pictures that the design refers to, and knows what its files held") {
    const TemporaryFolder folder;
    UnsavedWork work{painted_document().design, folder / "mine.nacre", {}};
    Layer& painted = work.design.distribution.layers.back();
    Layer modulated;
    modulated.modulation = Modulation{std::get<PaintedLobe>(painted.lobe).image, 0.5};
    modulated.modulation->image.file = folder / "gone.png";
    std::get<PaintedLobe>(painted.lobe).image.file = "/nowhere/\u00e4 \"odd\".png";
    work.design.distribution.layers.push_back(modulated);
    work.held = {{work.file, content_of("one")}, {folder / "gone.png", content_of("two")}};
    write_autosave(work, folder / autosave_name);
    CHECK(read_autosave(folder / autosave_name) == work);
}

TEST_CASE("autosave: one that is larger than a design file may be is restored") {
    const TemporaryFolder folder;
    const fs::path file = folder / autosave_name;
    const UnsavedWork work{painted_document().design, "/mine.nacre", {}};
    write_autosave(work, file);
    // White space, which JSON allows, in place of texels, which would take the test long.
    std::ofstream(file, std::ios::app) << std::string(limits::file_bytes_max, '\n');
    REQUIRE(!input_file_problem(file).empty());
    CHECK(read_autosave(file) == work);
    CHECK(read_autosave_head(file).file == work.file);
}

TEST_CASE("autosave: never writes or removes through what has taken its file's or its folder's place") {
    const TemporaryFolder folder;
    const fs::path unsaved = folder / "state/nacre/unsaved";
    write_all(folder / "letter.nacre", "mine");
    for (const bool whole_folder : {false, true}) {
        CAPTURE(whole_folder);
        Rig r({.bake_threads = 1, .folders = below(folder)});
        const auto edit = [&](const char* name) {
            r.document().design.name = name;
            r.play("frames 2");
            r.designer().autosave.wait();
            r.play("frames 1");
        };
        edit("one");
        REQUIRE(r.designer().autosave.problem().empty());
        fs::path own;
        for (const auto& entry : fs::directory_iterator(unsaved))
            if (read_all(entry.path() / autosave_name).find("one") != std::string::npos) own = entry.path();
        REQUIRE(!own.empty());
        if (whole_folder) {
            fs::rename(own, folder / "moved");
            fs::create_directory(folder / "elsewhere");
            fs::copy(folder / "moved" / "lock", folder / "elsewhere" / "lock");
            write_all(folder / "elsewhere" / autosave_name, "mine");
            fs::create_directory_symlink(folder / "elsewhere", own);
        } else {
            fs::remove(own / autosave_name);
            fs::create_symlink(folder / "letter.nacre", own / autosave_name);
        }
        edit("two");
        CHECK(r.designer().autosave.problem().empty());
        r.play("key Ctrl+Z\nframes 2");
        r.designer().autosave.wait();
        finish(r.designer());
        CHECK(read_all(folder / "letter.nacre") == "mine");
        CHECK(fs::is_symlink(whole_folder ? own : own / autosave_name));
        if (whole_folder) CHECK(read_all(folder / "elsewhere" / autosave_name) == "mine");
    }
}

TEST_CASE("autosave: work that is too large to be restored is told, and what was kept before stays") {
    const TemporaryFolder folder;
    constexpr std::uintmax_t most = 100'000;
    Rig r({.bake_threads = 1, .folders = below(folder), .autosave_bytes = most});
    const auto kept = [&](const auto& edit) {
        edit(r.document());
        r.play("frames 2");
        r.designer().autosave.wait();
        r.play("frames 2");
        return r.designer().autosave.problem();
    };
    const auto edited = [](Document& document) { document.design.name = "Edited"; };
    const auto painted = [](Document& document) {
        document.design.distribution = painted_document().design.distribution;
    };
    REQUIRE(kept(edited).empty());
    const std::string problem = kept(painted);
    CAPTURE(problem);
    CHECK(problem.find(
              "unsaved.nacre: write: the work is larger than the 100000 bytes that can be restored (") !=
          std::string::npos);
    CHECK(r.stage.items().rectangle("Said last"));
    fs::path file;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "state/nacre/unsaved"))
        if (entry.path().filename() == autosave_name) file = entry.path();
    CHECK(read_autosave(file).design.name == "Edited");
    // Smaller again, it is kept.
    CHECK(kept([](Document& document) { document.undo(); }).empty());
}

TEST_CASE("autosave: a limit is the largest size that is written") {
    const TemporaryFolder folder;
    const fs::path file = folder / autosave_name;
    const UnsavedWork work{starter_design(), {}, {}};
    write_autosave(work, file);
    const auto size = fs::file_size(file);
    write_autosave(work, file, size);
    CHECK_THROWS_AS(write_autosave(work, file, size - 1), UserError);
    CHECK(read_autosave(file) == work);
}
