// What is kept between runs: settings, recent files, unsaved work.
#include <doctest/doctest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <chrono>
#include <map>

#include "app/designer/recovery.h"
#include "core/design/design_file.h"
#include "core/design/error.h"
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
    UnsavedWork work{painted_document().design, "/some/where/\u00e4.nacre"};
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
    fs::create_directories(unsaved / "1-a");
    write_autosave({starter_design(), {}}, unsaved / "1-a" / autosave_name);
    fs::create_directories(unsaved / "2-b");
    write_all(unsaved / "2-b" / autosave_name, "{\"nacre_autosave\": 1}\n{\"nacre\"");
    fs::last_write_time(unsaved / "1-a" / autosave_name,
                        fs::last_write_time(unsaved / "2-b" / autosave_name) - std::chrono::minutes(1));
    fs::create_directories(unsaved / "3-c");  // nothing was kept
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        CHECK(r.designer().recovery.count() == 2);
        CHECK(!fs::exists(unsaved / "3-c"));
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

TEST_CASE("recovery: work that is in its file already counts as saved") {
    const TemporaryFolder folder;
    const fs::path file = folder / "mine.nacre";
    save_design(starter_design(), file);
    fs::create_directories(folder / "state/nacre/unsaved/1-a");
    write_autosave({starter_design(), file}, folder / "state/nacre/unsaved/1-a" / autosave_name);
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.play("frames 3\nkey Enter\nframes 3");
    CHECK(r.document().file == file);
    CHECK(!r.document().unsaved());
    r.designer().autosave.wait();
    CHECK(!fs::exists(folder / "state/nacre/unsaved/1-a"));
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
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                       fs::perms::others_exec);
    if (root) REQUIRE(seteuid(65534) == 0);
    check_refused_save(folder / "mine.nacre", "Permission denied");
    if (root) REQUIRE(seteuid(0) == 0);
    fs::permissions(folder.path(), fs::perms::owner_all);
}
