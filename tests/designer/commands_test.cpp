// Keys and menus of the whole designer: what each command does.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

#include "app/designer/command.h"
#include "core/design/design_file.h"
#include "core/formats/export_format.h"
#include "core/image/picture.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"
#include "ui/canvas_tools.h"
#include "ui/key_press.h"
#include "ui/shortcut_sheet.h"

using namespace nacre;
using nacre::test::read_all;
using nacre::test::Rig;
using nacre::test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("commands: X erases and goes back, digits choose layers, brackets size the brush, Tab hides") {
    Rig r;
    r.play("key B\nkey X");
    CHECK(r.canvas().tool == ui::CanvasTool::erase);
    r.play("key X");
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
    const double radius = r.canvas().brush.radius;
    r.play("key ]");
    CHECK(r.canvas().brush.radius > radius);
    r.play("key [");
    CHECK(r.canvas().brush.radius == doctest::Approx(radius));
    r.play("click \"New painted layer\"\nkey 1");
    CHECK(r.designer().layers.chosen == 0);
    r.play("key 2");
    CHECK(r.designer().layers.chosen == 1);
    r.play("key 9");
    CHECK(r.designer().layers.chosen == 1);
    CHECK(r.stage.items().rectangle("Layers"));
    r.play("key Tab\nframes 2");
    CHECK(!r.stage.items().rectangle("Layers"));
    CHECK(r.stage.items().rectangle("Canvas"));
    r.play("key Tab\nkey F11");
    CHECK(r.designer().panels);
    CHECK(r.designer().full_screen);
}

TEST_CASE("commands: F1 shows every shortcut once, and closes") {
    Rig r;
    r.play("key F1\nframes 3");
    CHECK(r.designer().sheet);
    r.play("key F1\nframes 3");
    CHECK(!r.designer().sheet);
    std::vector<std::string> keys;
    for (const ui::SheetGroup& group : ui::shortcut_groups(command_infos()))
        if (group.title != "Mouse")
            for (const ui::SheetLine& line : group.lines) keys.push_back(line.keys);
    const std::size_t all = keys.size();
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    CHECK(keys.size() == all);
}

TEST_CASE("commands: the manual shows the list of shortcuts as it is") {
    const std::string manual = read_all(NACRE_SOURCE_DIR "/docs/document.md");
    const std::string shortcuts = ui::shortcuts_markdown(command_infos());
    CHECK_MESSAGE(manual.find(shortcuts) != std::string::npos, shortcuts);
}

TEST_CASE("commands: each can be reached, and its keys are ones that there are") {
    for (const Command* command : commands()) {
        const ui::CommandInfo& info = command->info;
        CAPTURE(info.about);
        CHECK((info.label != nullptr || info.keys != nullptr));
        CHECK((info.about != nullptr || command->choices != nullptr));
        for (const char* keys : {info.keys, info.also})
            if (keys != nullptr && keys != std::string(ui::nine_digits)) CHECK(ui::parse_key(keys));
    }
}

TEST_CASE("commands: one that is disabled does nothing, by key neither") {
    Rig r;
    REQUIRE(!recover_command.enabled(r.designer()));
    const std::string message = r.designer().files.message();
    perform(r.designer(), recover_command);
    CHECK(r.designer().files.message() == message);
    REQUIRE(!redo_command.enabled(r.designer()));
    const Design design = r.document().design;
    r.play("key Ctrl+Y");
    CHECK(r.document().design == design);
}

TEST_CASE("commands: F12 asks once for a folder and then numbers its pictures") {
    const TemporaryFolder folder;
    Rig r;
    r.play("wait\nkey F12\nframes 5\ntext \"" + (folder / "shots").string() + "\"\nkey Enter\nframes 3");
    const auto idle = [&] { return !r.designer().pictures_of_preview.in_motion(); };
    REQUIRE(r.frames_until(idle));
    REQUIRE(fs::exists(folder / "shots/untitled-001.png"));
    const std::string first = read_all(folder / "shots/untitled-001.png");
    r.play("key F12\nframes 3");
    REQUIRE(r.frames_until(idle));
    CHECK(fs::exists(folder / "shots/untitled-002.png"));
    CHECK(read_all(folder / "shots/untitled-001.png") == first);
    const ColourPicture picture = load_colours(folder / "shots/untitled-001.png");
    CHECK(glm::ivec2(picture.width, picture.height) == r.designer().preview.size());
}

TEST_CASE("commands: Share as a web page opens the export with that format") {
    Rig r;
    r.play("wait");
    r.designer().exporter.options().chosen = 0;
    perform(r.designer(), share_page_command);
    CHECK(r.designer().exporter.talking());
    CHECK(export_formats()[r.designer().exporter.options().chosen] == &web_format);
    r.play("frames 3\nkey Escape\nframes 3");
    CHECK(!r.designer().exporter.talking());
}

TEST_CASE("commands: the export dialog writes each format") {
    const TemporaryFolder folder;
    Rig r;
    const auto idle = [&] { return !r.designer().exporter.talking(); };
    const auto write = [&](const std::string& format, const std::string& name) {
        r.play("key Ctrl+E\nframes 30\nclick \"Format " + format +
               "\"\nframes 30\nclick \"Choose export file\"\nframes 5\n" + "key Ctrl+A\ntext \"" +
               (folder / name).string() + "\"\nkey Enter\nframes 3");
        CHECK(r.frames_until(idle));
        CHECK(r.designer().files.message() == "Exported " + fs::path(name).filename().string());
    };
    r.play("wait");
    r.designer().exporter.options().tolerance = 0.1;
    r.designer().exporter.options().width = r.designer().exporter.options().height = 64;
    for (const ExportFormat* format : export_formats())
        write(std::string(format->title), std::string(format->name) + std::string(format->extension));
    write("Picture, PNG", "picture.png");
    write("Picture, EXR", "linear.exr");
    CHECK(fs::exists(folder / "exr/manifest.json"));
    CHECK(read_all(folder / "glsl.glsl").find("nacre_brdf") != std::string::npos);
    CHECK(load_colours(folder / "picture.png").width == 64);
    CHECK(load_colours(folder / "linear.exr").height == 64);
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
        CHECK(!entry.path().filename().string().starts_with('.'));
}

TEST_CASE("commands: the export dialog names the function as the file will") {
    const TemporaryFolder folder;
    Rig r;
    r.play("wait\nkey Ctrl+E\nframes 30\nclick \"Format GLSL function\"\nframes 30");
    ui::ExportDialog& options = r.designer().exporter.options();
    const auto about = [&] { return options.formats[options.chosen].about; };
    CHECK(about().find(" nacre_brdf(k1, k2) ") != std::string::npos);
    options.tolerance = 0.1;
    options.prefix = "wood2";
    r.play("frames 2");
    CHECK(about().find(" wood2_brdf(k1, k2) ") != std::string::npos);
    r.play("click \"Choose export file\"\nframes 5\nkey Ctrl+A\ntext \"" + (folder / "a.glsl").string() +
           "\"\nkey Enter\nframes 3");
    REQUIRE(r.frames_until([&] { return !r.designer().exporter.talking(); }));
    CHECK(read_all(folder / "a.glsl").find("vec3 wood2_brdf(vec3 k1, vec3 k2)") != std::string::npos);
}

TEST_CASE("commands: recent files open, and what is gone leaves the list") {
    const TemporaryFolder folder;
    Design design = starter_design();
    design.name = "Kept";
    save_design(design, folder / "kept.nacre");
    Rig r;
    r.designer().recent.note(folder / "gone.nacre");
    r.designer().recent.note(folder / "kept.nacre");
    perform(r.designer(), open_recent_command, 0);
    CHECK(r.document().design == design);
    perform(r.designer(), open_recent_command, 1);
    CHECK(r.designer().files.talking());
    CHECK(r.designer().recent.files() == std::vector<fs::path>{folder / "kept.nacre"});
}

TEST_CASE("commands: the menus hold the list, and one within another where any of it can be chosen") {
    const TemporaryFolder folder;
    Rig r;
    const auto shown = [&](const char* item) { return r.stage.items().rectangle(item).has_value(); };
    for (const char* menu : {"File", "Edit", "View", "Help"}) {
        r.play("click \"" + std::string(menu) + "\"\nframes 3");
        for (const Command* command : commands())
            if (command->info.label != nullptr && command->choices == nullptr)
                CHECK(shown(command->info.label) == (std::string(command->info.menu) == menu));
        r.play("key Escape\nframes 30");
    }
    r.play("click \"File\"\nframes 3\nclick \"Open recent\"\nframes 3");
    CHECK(!shown("Clear the list"));
    r.play("key Escape\nframes 30");
    Design design = starter_design();
    for (const char* name : {"a", "b"}) {
        design.name = name;
        save_design(design, folder / (std::string(name) + ".nacre"));
        r.designer().recent.note(folder / (std::string(name) + ".nacre"));
    }
    r.play("click \"File\"\nframes 3\nmove \"Open recent\"\nframes 30\nclick \"Recent 2\"\nframes 5");
    CHECK(r.document().design.name == "a");
    r.play("click \"File\"\nframes 3\nmove \"Open recent\"\nframes 30\nclick \"Clear the list\"\nframes 5");
    CHECK(r.designer().recent.files().empty());
}

TEST_CASE("commands: a dropped design opens, with the question where work would be lost") {
    const TemporaryFolder folder;
    Design design = starter_design();
    design.name = "Dropped";
    save_design(design, folder / "a b.nacre");
    Rig r;
    r.play("drag \"Width x\":0.5 \"Width x\":0.3 5\ndrop \"" + (folder / "a b.nacre").string() +
           "\"\nframes 5");
    CHECK(r.document().design.name.empty());
    r.play("click \"Discard\"\nframes 5");
    CHECK(r.document().design == design);
    CHECK(!r.document().unsaved());
}

TEST_CASE("presets: the wall gets its pictures") {
    Rig r;
    r.play("click \"Presets\"\nframes 2");
    const auto& presets = r.designer().presets;
    REQUIRE(!presets.empty());
    CHECK(r.frames_until([&] { return r.designer().thumbnails.texture(presets[0].file) != nullptr; }));
}

TEST_CASE("commands: no key stands for two of them, or for a command and a tool") {
    std::map<std::string, std::string> meant;
    const auto add = [&](const char* keys, const char* what) {
        if (keys == nullptr) return;
        CAPTURE(keys);
        CAPTURE(what);
        CHECK_MESSAGE(meant.emplace(keys, what).second, meant[keys]);
    };
    for (const ui::CommandInfo* info : command_infos()) {
        add(info->keys, info->about);
        add(info->also, info->about);
    }
    for (const ui::ToolEntry& tool : ui::canvas_tools())
        add(std::string(1, tool.face->key).c_str(), tool.face->name);
    CHECK(meant.size() > 40);
}
