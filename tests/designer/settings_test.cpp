// Settings and recent files, and where they are kept.
#include "app/designer/settings.h"

#include <doctest/doctest.h>

#include <map>

#include "tests/designer/kept_work.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

EnvironmentVariables environment_of(std::map<std::string, std::string> variables) {
    return [variables = std::move(variables)](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    };
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
    const Habits habits{
        .tool = "Smear",
        .brush = {.radius = 3.25, .opacity = 0.1, .blend = Blend::multiply},
        .steadiness = 12.5,
        .own_brushes = {{"my \"own\"", {.value = 0.3}}, {"another", {.spacing = 1.5, .blend = Blend::add}}},
        .tolerance = 0.25,
        .form = GradientForm::radial,
        .scale = ScaleKind::logarithmic,
        .highlight = false,
        .object = "torus",
        .yaw = 30.5,
        .pitch = -20,
        .zoom = 2};
    {
        SettingsFile file(folder / "a/b");
        CHECK(file.problem().empty());
        file.values.layout = {.panel = 31.7f, .canvas = 0.375f, .drawer = 22.1f};
        file.values.system_dialogs = false;
        file.values.picture_folder = "/pictures/\"odd\" \u00e4";
        file.values.habits = habits;
        file.keep();
    }
    const SettingsFile file(folder / "a/b");
    CHECK(file.values.layout == Layout{31.7f, 0.375f, 22.1f});
    CHECK(!file.values.system_dialogs);
    CHECK(file.values.picture_folder == "/pictures/\"odd\" \u00e4");
    CHECK(file.values.habits == habits);
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

TEST_CASE("recent files: a name that the system would cut off is none") {
    const TemporaryFolder folder;
    write_all(folder / "recent.json", "{\"nacre_recent\": 1, \"files\": [\"/a\\u0000.nacre\"]}");
    const RecentFiles recent(folder.path());
    CHECK(recent.files().empty());
    CHECK(recent.problem().find("NUL") != std::string::npos);
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
