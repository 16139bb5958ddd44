// Questions for files: through the desktop's dialogs, and through Nacre's browser.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/design/design_file.h"
#include "core/image/image_file.h"
#include "tests/designer/dialog_stand_in.h"

using namespace nacre;
using nacre::test::ask;
using nacre::test::Asking;
using nacre::test::environment_map;
using nacre::test::object;
using nacre::test::plot;
using nacre::test::read_all;
using nacre::test::StandIn;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;
namespace fs = std::filesystem;
using Kind = DialogProgram::Kind;
using Words = std::vector<std::string>;

namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

struct Rig : test::Rig {
    Rig() : Rig(std::nullopt) {}
    explicit Rig(const std::optional<DialogProgram>& program)
        : test::Rig(StageOptions{.bake_threads = 1, .dialogs = program}) {
        designer().plots.state.open = true;
        play("wait\nframes 20");
    }
    const Scene& scene() { return designer().scene; }
};

}  // namespace

TEST_CASE("desktop's dialog: found by PATH and desktop, and only with a display") {
    const TemporaryFolder folder;
    for (const char* name : {"zenity", "kdialog"}) {
        write_all(folder / name, "");
        fs::permissions(folder / name, fs::perms::owner_all);
    }
    const std::string path = "/nowhere:" + folder.path().string();
    const auto found = [&](const char* display, const char* desktop) {
        return find_dialog_program([&, display, desktop](const char* name) -> const char* {
            const std::string_view variable = name;
            return variable == "PATH"                  ? path.c_str()
                   : variable == "DISPLAY"             ? display
                   : variable == "XDG_CURRENT_DESKTOP" ? desktop
                                                       : nullptr;
        });
    };
    CHECK(!found(nullptr, nullptr));
    REQUIRE(found(":0", nullptr));
    CHECK(found(":0", "GNOME")->file == folder / "zenity");
    CHECK(found(":0", "KDE")->file == folder / "kdialog");
    CHECK(found(":0", "KDE")->kind == Kind::kdialog);
}

TEST_CASE("desktop's dialog: no shell reads the names, and its answer is a file") {
    const TemporaryFolder folder;
    const fs::path odd = folder / "it's $(odd) \"here\"";
    fs::create_directory(odd);
    save_design(starter_design(), odd / "a; b.nacre");
    const StandIn dialog;
    Rig r(dialog.program());
    r.designer().settings.values.design_folder = odd;
    dialog.answer(odd / "a; b.nacre");
    r.play("key Ctrl+O\nframes 2");
    REQUIRE(r.frames_until([&] { return !r.designer().files.talking(); }));
    CHECK(r.document().file == odd / "a; b.nacre");
    CHECK(dialog.arguments() == Words{"--file-selection", "--title=Open design",
                                      "--filename=" + odd.string() + "/",
                                      "--file-filter=Nacre design | *.nacre *.NACRE"});
    r.play("key F1\nframes 2");
    CHECK(r.designer().sheet);  // nothing stays popped up that would hold the keys
}

TEST_CASE("desktop's dialog: a design that was never saved is named after itself") {
    const TemporaryFolder folder;
    const StandIn dialog;
    Rig r(dialog.program());
    r.designer().settings.values.design_folder = folder.path();
    r.document().design.name = "Brushed Copper";
    dialog.answer(folder / "mine");
    r.play("key Ctrl+S\nframes 2");
    REQUIRE(r.frames_until([&] { return !r.designer().files.talking(); }));
    CHECK(dialog.arguments().at(3) == "--filename=" + (folder / "brushed-copper.nacre").string());
    CHECK(r.document().file == folder / "mine.nacre");
    CHECK(load_design(folder / "mine.nacre") == r.document().design);
}

TEST_CASE("desktop's dialog: given up, and where it cannot be started the browser asks") {
    const TemporaryFolder folder;
    const StandIn dialog;
    for (const bool there : {true, false}) {
        Rig r(there ? dialog.program() : DialogProgram{Kind::zenity, folder / "missing"});
        for (const char* script :
             {"key Ctrl+O\nframes 2", environment_map.script, object.script, plot.script}) {
            CAPTURE(script);
            r.play(script);
            r.play("frames 30");
            CHECK(talking(r.designer()));
            CHECK(r.stage.items().rectangle("Path").has_value() != there);
            r.play("click \"Cancel\"\nframes 5");
            CHECK(!talking(r.designer()));
        }
    }
}

TEST_CASE("desktop's dialog: zenity is asked for an environment map, an object and a plot's file") {
    const TemporaryFolder folder;
    write_image(folder / "sky.exr", {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
    write_all(folder / "Mine.OBJ", triangle);
    const StandIn dialog;
    Rig r(dialog.program());
    const std::string here = "--filename=" + folder.path().string() + "/";
    const Words pictures = {
        "--file-selection", "--title=Open environment map",
        "--file-filter=Lat-long picture | *.exr *.EXR *.hdr *.HDR *.tif *.TIF *.tiff *.TIFF "
        "*.pfm *.PFM *.ppm *.PPM *.png *.PNG *.jpg *.JPG *.jpeg *.JPEG *.webp *.WEBP *.tga *.TGA *.bmp *.BMP "
        "*.psd *.PSD *.dds *.DDS *.jp2 *.JP2 *.j2k *.J2K *.heic *.HEIC *.heif *.HEIF *.avif *.AVIF"};
    const Words objects = {"--file-selection", "--title=Open object",
                           "--file-filter=Wavefront OBJ | *.obj *.OBJ"};
    const auto plots = [](const std::string& start) {
        return Words{"--file-selection", "--title=Save plot as", "--save", start + "untitled-masking.svg",
                     "--file-filter=Plot, SVG or CSV | *.svg *.SVG *.csv *.CSV"};
    };
    const auto beginning = [&](Words words) {
        words.insert(words.begin() + 2, here);
        return words;
    };
    r.play("click \"Plot masking\"\nwait");

    ask(r, dialog, object, folder / "Mine.OBJ");
    CHECK(dialog.arguments() == objects);
    CHECK(r.scene().object.name == (folder / "Mine.OBJ").string());
    ask(r, dialog, object, {});
    CHECK(dialog.arguments() == beginning(objects));

    ask(r, dialog, plot, folder / "p.csv");
    CHECK(dialog.arguments() == plots("--filename="));
    CHECK(r.designer().files.message() == "Saved p.csv");
    CHECK(read_all(folder / "p.csv").find('<') == std::string::npos);
    ask(r, dialog, plot, folder / "p");
    CHECK(dialog.arguments() == plots(here));
    CHECK(r.designer().files.message() == "Saved p.svg");
    CHECK(folder.size() == 4);

    ask(r, dialog, environment_map, folder / "sky.exr");
    CHECK(dialog.arguments() == pictures);
    REQUIRE(r.scene().environment.picture);
    CHECK(r.scene().environment.picture->name == (folder / "sky.exr").string());
    ask(r, dialog, environment_map, {});
    CHECK(dialog.arguments() == beginning(pictures));
}

TEST_CASE("desktop's dialog: kdialog is asked for an environment map, an object and a plot's file") {
    const TemporaryFolder folder;
    write_image(folder / "sky.exr", {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
    write_all(folder / "Mine.OBJ", triangle);
    const StandIn dialog(Kind::kdialog);
    Rig r(dialog.program());
    r.play("click \"Plot masking\"\nwait");
    ask(r, dialog, environment_map, folder / "sky.exr");
    CHECK(dialog.arguments() == Words{"--title", "Open environment map", "--getopenfilename", "./",
                                      "*.exr *.hdr *.tif *.tiff *.pfm *.ppm *.png *.jpg *.jpeg *.webp *.tga "
                                      "*.bmp *.psd *.dds *.jp2 *.j2k *.heic *.heif *.avif"});
    CHECK(r.scene().environment.picture);
    ask(r, dialog, object, folder / "Mine.OBJ");
    CHECK(dialog.arguments() == Words{"--title", "Open object", "--getopenfilename", "./", "*.obj"});
    CHECK(r.scene().object.mesh);
    ask(r, dialog, plot, folder / "p.svg");
    CHECK(dialog.arguments() ==
          Words{"--title", "Save plot as", "--getsavefilename", "./untitled-masking.svg", "*.svg *.csv"});
    CHECK(r.designer().files.message() == "Saved p.svg");
}

TEST_CASE("desktop's dialog: while it is open no key reaches the designer, and its answer draws a frame") {
    const StandIn dialog;
    Rig r(dialog.program());
    for (const Asking& asking : {environment_map, object, plot}) {
        dialog.answer_no_more();
        r.play(asking.script);
        const ui::CanvasTool tool = r.canvas().tool;
        r.play("key B\nkey F1\nkey Tab\nframes 20");
        CHECK(r.canvas().tool == tool);
        CHECK(!r.designer().sheet);
        CHECK(r.designer().panels);
        CHECK(!in_motion(r.designer()));
        dialog.cancel();
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(15);
        while (!in_motion(r.designer()) && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        CHECK(in_motion(r.designer()));
        r.play("frames 3");
        CHECK(!talking(r.designer()));
        CHECK(!in_motion(r.designer()));
        r.play("key F1\nframes 2");
        CHECK(r.designer().sheet);
        r.play("key F1\nframes 2");
    }
}

TEST_CASE("desktop's dialog: a cancel changes nothing") {
    const StandIn dialog;
    Rig r(dialog.program());
    const Scene scene = r.scene();
    const Design design = r.document().design;
    const std::string message = r.designer().files.message();
    for (const Asking& asking : {environment_map, object, plot}) ask(r, dialog, asking, {});
    CHECK(r.scene() == scene);
    CHECK(r.document().design == design);
    CHECK(r.designer().files.message() == message);
}

TEST_CASE("desktop's dialog: a chosen file that cannot be used is told in a few words, and nothing changes") {
    const TemporaryFolder folder;
    write_all(folder / "notes.exr", "no picture\n");
    write_all(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    const StandIn dialog;
    Rig r(dialog.program());
    const Scene scene = r.scene();
    const auto tells = [&](const Asking& asking, const fs::path& file) {
        ask(r, dialog, asking, file);
        REQUIRE(r.frames_until([&] { return asking.talking(r.designer()); }));
        const std::string problem = asking.problem(r.designer());
        CHECK(problem.find(file.filename().string()) != std::string::npos);
        // A picture's file stands in a line of its own, behind the words.
        CHECK(std::ranges::count(problem, '\n') <= 2);
        CHECK(r.scene() == scene);
        r.play("frames 30\nclick \"OK\"\nframes 5");
        CHECK(!talking(r.designer()));
    };
    tells(environment_map, folder / "notes.exr");
    tells(object, folder / "bad.obj");
    tells(plot, folder / "nowhere/p.svg");
    CHECK(folder.size() == 2);
}

TEST_CASE("browser: shows the files of the question's extensions, in small letters and capitals") {
    const TemporaryFolder folder;
    for (const char* name : {"a.JPEG", "b.hdr", "c.obj", "D.OBJ", "e.csv", "f.svg", "g.txt", "h"})
        write_all(folder / name, "");
    Rig r;
    const auto shows = [&](const Asking& asking, const std::vector<std::string>& names) {
        r.play(asking.script + std::string("\nframes 2\nkey Ctrl+A\ntext \"") + folder.path().string() +
               "\"\nkey Enter\nframes 3");
        for (const auto& entry : fs::directory_iterator(folder.path())) {
            const std::string name = entry.path().filename().string();
            CAPTURE(name);
            const bool shown = std::find(names.begin(), names.end(), name) != names.end();
            CHECK(r.stage.items().rectangle(name).has_value() == shown);
        }
        r.play("click \"Cancel\"\nframes 3");
    };
    shows(environment_map, {"a.JPEG", "b.hdr"});
    shows(object, {"c.obj", "D.OBJ"});
    shows(plot, {"e.csv", "f.svg"});
}

TEST_CASE("browser: a name to save under gets the first extension where it has none of the question's") {
    const TemporaryFolder folder;
    Rig r;
    const auto save = [&](const std::string& script, const char* name) {
        r.play(script + "\nframes 2\nkey Ctrl+A\ntext \"" + (folder / name).string() +
               "\"\nkey Enter\nframes 3");
        CHECK(!talking(r.designer()));
    };
    for (const char* name : {"a", "b.v2", "c.csv", "D.SVG"}) save(plot.script, name);
    for (const char* name : {"a.svg", "b.v2.svg", "c.csv", "D.SVG"}) CHECK(fs::exists(folder / name));
    CHECK(read_all(folder / "D.SVG") == read_all(folder / "a.svg"));
    save("key Ctrl+Shift+S", "lacquer v1.2");
    CHECK(r.document().file == folder / "lacquer v1.2.nacre");
    CHECK(folder.size() == 5);
}
