// What is kept between runs: settings, recent files, unsaved work.
#include <doctest/doctest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <map>
#include <set>

#include "app/designer/recovery.h"
#include "core/design/design_file.h"
#include "core/design/error.h"
#include "core/exchange/input_file.h"
#include "core/paint/painted_layer.h"
#include "tests/core/file_size_limit.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::FileSizeLimit;
using nacre::test::read_all;
using nacre::test::Rig;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;
namespace fs = std::filesystem;

namespace {

UserFolders below(const TemporaryFolder& folder) {
    return {.config = folder / "config/nacre",
            .state = folder / "state/nacre",
            .data = folder / "data/nacre",
            .home = folder.path()};
}

EnvironmentVariables environment_of(std::map<std::string, std::string> variables) {
    return [variables = std::move(variables)](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    };
}

// A design whose file has some megabytes.
Document painted_document() {
    Document document;
    Layer layer = blank_painted_layer();
    auto raster = std::make_shared<Raster>(*std::get<PaintedLobe>(layer.lobe).image.raster);
    for (std::size_t i = 0; i < raster->values.size(); ++i)
        raster->values[i] = static_cast<float>(i % 1000) * 0.001f;
    set_raster(layer, raster, 0, 1);
    document.design.distribution.layers.push_back(layer);
    document.commit();
    return document;
}

// Saving there must fail with the system's reason, and leave the file, the work and the question before it is
// lost as they were.
void check_refused_save(const fs::path& file, const std::string& reason) {
    Rig r;
    r.document() = painted_document();
    r.document().file = file;
    r.document().held = held_now(std::vector<fs::path>{file});
    const Design before = r.document().design;
    const std::string on_disk = read_all(file);
    r.play("key Ctrl+S\nframes 5");
    CHECK(r.designer().files.talking());
    CHECK_MESSAGE(r.designer().files.problem().find(reason) != std::string::npos,
                  r.designer().files.problem());
    r.play("key Enter\nframes 5");
    CHECK(r.document().design == before);
    CHECK(r.document().unsaved());
    CHECK(read_all(file) == on_disk);
}

}  // namespace

TEST_CASE("folders: as the XDG specification says") {
    const UserFolders usual = user_folders(environment_of({{"HOME", "/home/ada"}}));
    CHECK(usual.config == "/home/ada/.config/nacre");
    CHECK(usual.state == "/home/ada/.local/state/nacre");
    CHECK(usual.data == "/home/ada/.local/share/nacre");
    const UserFolders set = user_folders(
        environment_of({{"HOME", "/home/ada"}, {"XDG_CONFIG_HOME", "/c"}, {"XDG_STATE_HOME", "s"}}));
    CHECK(set.config == "/c/nacre");
    CHECK(set.state == "/home/ada/.local/state/nacre");  // a relative path counts as none
    CHECK(user_folders(environment_of({})).state.empty());
}

TEST_CASE("settings: what is set is there again") {
    const TemporaryFolder folder;
    {
        SettingsFile file(folder / "a/b");
        CHECK(file.problem().empty());
        file.values.layout = {.panel = 31.7f, .canvas = 0.375f, .drawer = 22.1f};
        file.values.system_dialogs = false;
        file.values.picture_folder = "/pictures/\"odd\" \u00e4";
        file.keep();
    }
    const SettingsFile file(folder / "a/b");
    CHECK(file.values.layout == Layout{31.7f, 0.375f, 22.1f});
    CHECK(!file.values.system_dialogs);
    CHECK(file.values.picture_folder == "/pictures/\"odd\" \u00e4");
}

TEST_CASE("settings: what a file does not say is as in a first run") {
    const TemporaryFolder folder;
    write_all(folder / "settings.json", "{\"nacre_settings\": 1, \"system_dialogs\": false}");
    const SettingsFile file(folder.path());
    CHECK(file.problem().empty());
    CHECK(file.values.layout == Layout{});
    CHECK(!file.values.system_dialogs);
}

TEST_CASE("settings: a damaged file is told in one line and kept") {
    const TemporaryFolder folder;
    for (const std::string damaged :
         {"{\"nacre_settings\": 1, \"panel\": ", "[]", "{\"nacre_settings\": 9}", "\xff\xfe",
          "{\"nacre_settings\": 1, \"panel\": \"wide\"}", "{\"nacre_settings\": 1, \"panel\": 0}"}) {
        write_all(folder / "settings.json", damaged);
        SettingsFile file(folder.path());
        CAPTURE(damaged);
        CHECK(file.problem().find("settings.json") != std::string::npos);
        CHECK(file.problem().find('\n') == std::string::npos);
        CHECK(file.values == Settings{});
        file.values.system_dialogs = false;
        file.keep();
        CHECK(!SettingsFile(folder.path()).values.system_dialogs);
    }
    for (int i = 1; i <= 6; ++i) CHECK(fs::exists(folder / ("settings.json.damaged-" + std::to_string(i))));
    CHECK(read_all(folder / "settings.json.damaged-2") == "[]");
}

TEST_CASE("recent files: newest first, none twice, and two windows add to one list") {
    const TemporaryFolder folder;
    RecentFiles one(folder.path()), other(folder.path());
    one.note("/a.nacre");
    other.note("/b.nacre");
    one.note("/c.nacre");
    one.note("/a.nacre");
    using Paths = std::vector<fs::path>;
    CHECK(RecentFiles(folder.path()).files() == Paths{"/a.nacre", "/c.nacre", "/b.nacre"});
    other.forget("/c.nacre");
    CHECK(RecentFiles(folder.path()).files() == Paths{"/a.nacre", "/b.nacre"});
    for (int i = 0; i < 30; ++i) one.note("/" + std::to_string(i));
    CHECK(one.files().size() == RecentFiles::files_max);
}

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
        CHECK(own_orphans(unsaved).empty());  // its owner lives
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

TEST_CASE("recent files: a name that the system would cut off is none") {
    const TemporaryFolder folder;
    write_all(folder / "recent.json", "{\"nacre_recent\": 1, \"files\": [\"/a\\u0000.nacre\"]}");
    const RecentFiles recent(folder.path());
    CHECK(recent.files().empty());
    CHECK(recent.problem().find("NUL") != std::string::npos);
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

TEST_CASE("a run without folders reads and writes nothing of the user's") {
    const TemporaryFolder folder;
    REQUIRE(setenv("HOME", folder.path().c_str(), 1) == 0);
    Rig r;
    r.play("drag \"Width x\":0.5 \"Width x\":0.3 5\nframes 3");
    CHECK(!r.designer().autosave.busy());
    finish(r.designer());
    CHECK(folder.size() == 0);
}

TEST_CASE("full disk: a file that may not grow is told, and the work is still there") {
    const TemporaryFolder folder;
    write_all(folder / "mine.nacre", "old");
    const FileSizeLimit limit(100'000);
    check_refused_save(folder / "mine.nacre", "File too large");
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.document() = painted_document();
    r.play("frames 1");
    r.designer().autosave.wait();
    r.play("frames 1");
    CHECK(r.designer().autosave.problem().find("File too large") != std::string::npos);
}

TEST_CASE("full disk: a small tmpfs") {
    const TemporaryFolder folder;
    if (::mount("nacre", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0) {
        MESSAGE("skipped: no tmpfs can be mounted here");
        return;
    }
    write_all(folder / "mine.nacre", "old");
    check_refused_save(folder / "mine.nacre", "No space left on device");
    ::umount(folder.path().c_str());
}

TEST_CASE("read-only folder: told, and the work is still there") {
    const TemporaryFolder folder;
    write_all(folder / "mine.nacre", "old");
    // What is forbidden to others is allowed to root: it becomes nobody for a while.
    const bool root = geteuid() == 0;
    fs::permissions(folder.path(), fs::perms(0555));
    if (root) REQUIRE(seteuid(65534) == 0);
    check_refused_save(folder / "mine.nacre", "Permission denied");
    if (root) REQUIRE(seteuid(0) == 0);
    fs::permissions(folder.path(), fs::perms::owner_all);
}
