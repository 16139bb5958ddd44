// What the window says after an export, and the folder that it opens.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/designer/folder_opener.h"
#include "core/formats/export_format.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;
using nacre::test::read_all;
using nacre::test::Rig;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;
namespace fs = std::filesystem;

namespace {

// Stands in for xdg-open: writes down what it is to open.
fs::path opener(const TemporaryFolder& folder, int code) {
    const fs::path program = folder / "xdg-open";
    write_all(program,
              "#!/bin/sh\nprintf '%s|' \"$@\" >\"$(dirname \"$0\")/opened.part\"\nmv \"$(dirname "
              "\"$0\")/opened.part\" \"$(dirname \"$0\")/opened\"\nexit " +
                  std::to_string(code) + "\n");
    fs::permissions(program, fs::perms::owner_all);
    return program;
}

void export_as(Rig& r, const std::string& format, const fs::path& file) {
    r.play("wait");
    r.designer().exporter.options().tolerance = 0.1;
    r.play("key Ctrl+E\nframes 30\nclick \"Format " + format +
           "\"\nframes 30\nclick \"Choose export file\"\nframes 5\nkey Ctrl+A\ntext \"" + file.string() +
           "\"\nkey Enter\nframes 3");
    REQUIRE(r.frames_until([&] { return !r.designer().exporter.talking(); }));
    r.play("frames 3");
}

bool shown(Rig& r, const char* item) { return r.stage.items().rectangle(item).has_value(); }

}  // namespace

TEST_CASE("export report: tells the files and the next steps, and takes nothing but Enter and Escape") {
    const TemporaryFolder folder;
    Rig r;
    CHECK(!shown(r, "Exported files"));
    r.designer().exporter.options().prefix = "satin";
    export_as(r, "GLSL function", folder / "a.glsl");
    REQUIRE(r.designer().exporter.report());
    const ui::ExportReport& report = *r.designer().exporter.report();
    CHECK(report.files == std::vector<std::string>{"a.glsl"});
    CHECK(report.folder == folder.path().string());
    CHECK(report.steps == next_steps(glsl_format, "satin", folder / "a.glsl"));
    CHECK(shown(r, "Exported files"));
    CHECK(shown(r, "Next step 2"));
    // The rest of the window goes on.
    r.play("key B\nframes 2");
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
    const double width = std::get<GaussianLobe>(r.layers()[0].lobe).sigma_x;
    r.play("drag \"Width x\":0.5 \"Width x\":0.7 5\nframes 2");
    CHECK(std::get<GaussianLobe>(r.layers()[0].lobe).sigma_x != width);
    // Escape is for the list on top of it first.
    r.play("click \"Lobe\"\nframes 20\nkey Escape\nframes 20");
    CHECK(r.designer().exporter.report());
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().exporter.report());
    CHECK(!shown(r, "Exported files"));
    export_as(r, "GLSL function", folder / "b.glsl");
    REQUIRE(r.designer().exporter.report());
    r.play("key Enter\nframes 3");
    CHECK(!r.designer().exporter.report());
}

TEST_CASE("export report: of a folder it names every file that was written") {
    const TemporaryFolder folder;
    Rig r;
    export_as(r, "Tables as EXR pictures", folder / "tables");
    REQUIRE(r.designer().exporter.report());
    const ui::ExportReport& report = *r.designer().exporter.report();
    CHECK(report.folder == (folder / "tables").string());
    std::size_t there = 0;
    for (const auto& entry : fs::directory_iterator(folder / "tables")) {
        CHECK(std::ranges::count(report.files, entry.path().filename().string()) == 1);
        ++there;
    }
    CHECK(report.files.size() == there);
    CHECK(there >= 4);
}

TEST_CASE("export report: pictures tell a next step too, and a new export takes the place of the old") {
    const TemporaryFolder folder;
    Rig r;
    r.designer().exporter.options().width = r.designer().exporter.options().height = 64;
    export_as(r, "Picture, EXR", folder / "a.exr");
    REQUIRE(r.designer().exporter.report());
    CHECK(r.designer().exporter.report()->steps.size() == 2);
    r.play("key Ctrl+E\nframes 5");
    CHECK(!r.designer().exporter.report());
    r.play("key Escape\nframes 5");
    CHECK(!r.designer().exporter.report());
}

TEST_CASE("export report: the button opens the folder, with its name as one word") {
    const TemporaryFolder folder, tools;
    fs::create_directory(folder / "a b");
    Rig r(StageOptions{.bake_threads = 1, .folder_opener = opener(tools, 0)});
    export_as(r, "GLSL function", folder / "a b/a.glsl");
    r.play("click \"Open folder\"\nframes 2");
    REQUIRE(r.frames_until([&] { return fs::exists(tools / "opened"); }));
    CHECK(read_all(tools / "opened") == (folder / "a b").string() + "|");
    r.play("frames 5");
    CHECK(r.designer().exporter.report()->problem.empty());
}

TEST_CASE("export report: says so where nothing opens folders, and where that fails") {
    const TemporaryFolder folder, tools;
    {
        Rig r;
        export_as(r, "GLSL function", folder / "a.glsl");
        r.play("click \"Open folder\"\nframes 3");
        CHECK(r.designer().exporter.report()->problem ==
              "There is no program here that opens folders: xdg-open is not installed.");
        CHECK(shown(r, "Open folder problem"));
    }
    Rig r(StageOptions{.bake_threads = 1, .folder_opener = opener(tools, 4)});
    export_as(r, "GLSL function", folder / "b.glsl");
    r.play("click \"Open folder\"\nframes 3");
    REQUIRE(r.frames_until([&] { return !r.designer().exporter.report()->problem.empty(); }));
    CHECK(r.designer().exporter.report()->problem ==
          "xdg-open could not open " + folder.path().string() + ".");
}

TEST_CASE("folder opener: xdg-open of PATH, and none without a display") {
    const TemporaryFolder tools;
    const fs::path program = opener(tools, 0);
    const auto variables = [&](const char* display) {
        return [=, path = tools.path().string()](const char* name) -> const char* {
            if (name == std::string("PATH")) return path.c_str();
            return name == std::string("DISPLAY") ? display : nullptr;
        };
    };
    CHECK(find_folder_opener(variables(":0")) == program);
    CHECK(find_folder_opener(variables(nullptr)).empty());
    fs::remove(program);
    CHECK(find_folder_opener(variables(":0")).empty());
}
