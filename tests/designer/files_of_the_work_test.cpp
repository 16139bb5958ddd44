// The files that work comes from: what cannot be read at the start, and outputs that would replace one.
#include <doctest/doctest.h>

#include <tuple>

#include "core/formats/export_format.h"
#include "tests/designer/changed_files.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

TEST_CASE("started with a file that cannot be read: the window says why, over a new design") {
    const TemporaryFolder folder;
    write_all(folder / "broken.nacre", "{ broken");
    write_all(
        folder / "pictured.nacre",
        "{\"nacre\": 1, \"distribution\": {\"layers\": [{\"lobe\": \"painted\", \"image\": \"gone.png\"}]}}");
    for (const char* name : {"broken.nacre", "pictured.nacre", "missing.nacre", "."}) {
        CAPTURE(name);
        FileRig r(folder / name);
        const std::string problem = r.designer().files.problem();
        CHECK(problem.find(folder.path().string()) != std::string::npos);
        CHECK(problem.find('\n') == std::string::npos);
        CHECK(r.document().design == starter_design());
        CHECK(r.document().file.empty());
        r.play("frames 30\nkey Enter\nframes 3");
        CHECK(!talking(r.designer()));
    }
}

TEST_CASE("an output is none of the files that the work came from, whatever it is called") {
    const Pictured folder;
    write_sky(folder / "sky.exr", 0.5f);
    FileRig r(folder.file);
    r.designer().environment.want((folder / "sky.exr").string());
    r.play("wait");
    r.designer().plots.state.open = true;
    r.play("wait\nframes 20");
    fs::create_symlink("paper.exr", folder / "link.nacre");
    fs::create_hard_link(folder / "mine.nacre", folder / "hard.svg");
    fs::create_symlink("mine.nacre", folder / "soft.glsl");
    const std::string paper = read_all(folder / "paper.exr"), mine = read_all(folder / "mine.nacre"),
                      sky = read_all(folder / "sky.exr");
    const auto type = [&](const char* name) {
        r.play("key Ctrl+A\ntext \"" + (folder / name).string() + "\"\nkey Enter\nframes 5");
    };
    r.play("key Ctrl+Shift+S\nframes 3");
    type("link.nacre");
    CHECK(r.designer().files.problem().find("paper.exr") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3\nclick \"Save plot\"\nframes 3");
    type("hard.svg");
    r.play("frames 30\nkey Enter\nframes 3");
    CHECK(r.designer().plots.saving.problem().find("mine.nacre") != std::string::npos);
    r.play("frames 30\nkey Enter\nframes 3");
    // GLSL over the design by another name, and the preview over the environment map.
    for (const auto& [format, name, input] :
         {std::tuple(std::size_t{1}, "soft.glsl", "mine.nacre"),
          std::tuple(export_formats().size() + 1, "sky.exr", "sky.exr")}) {
        r.play("key Ctrl+E\nframes 3");
        r.designer().exporter.options().chosen = format;
        r.play("frames 2\nclick \"Choose export file\"\nframes 3");
        type(name);
        CHECK(r.designer().exporter.problem().find(input) != std::string::npos);
        r.play("frames 30\nkey Enter\nframes 3");
    }
    CHECK(!talking(r.designer()));
    CHECK(read_all(folder / "paper.exr") == paper);
    CHECK(read_all(folder / "mine.nacre") == mine);
    CHECK(read_all(folder / "sky.exr") == sky);
}
