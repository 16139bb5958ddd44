// No output is one of the inputs, and no two outputs of one command are one file.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <filesystem>

#include "core/image/image_file.h"
#include "core/image/picture.h"
#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

// A folder of inputs of every kind, whose bytes can be compared with what they were.
struct Inputs {
    TemporaryFolder folder;
    std::string design = folder / "d.nacre", other = folder / "other.nacre", picture = folder / "area.exr",
                environment = folder / "sky.exr", object = folder / "o.obj", script = folder / "events";

    Inputs() {
        write_image(picture, {4, 4}, std::vector<float>(48, 0.5f));
        write_image(environment, {16, 8}, std::vector<float>(16 * 8 * 3, 0.5f));
        write_all(object, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write_all(script, fmt::format("move 10 10\ndrop \"{}\"\n", environment));
        write_all(design, R"({"nacre": 1, "distribution": {"layers": [{"lobe": "gaussian",
            "modulation": {"image": "area.exr", "strength": 0.5}}]}})");
        save_design(design_of(GaussianLobe{}), other);
        fs::create_hard_link(design, folder / "hard.png");
        fs::create_symlink("d.nacre", folder / "soft.svg");
        fs::create_hard_link(picture, folder / "d.png");
        fs::create_hard_link(environment, folder / "sky.png");
        fs::create_symlink("events", folder / "events.png");
        before = contents();
    }

    std::string contents() const {
        std::string all;
        for (const std::string& file : {design, other, picture, environment, object, script})
            all += read_all(file) + "|";
        return all;
    }

    std::string before;
};

}  // namespace

TEST_CASE("no output is one of the inputs, whatever the verb and the name") {
    const Inputs in;
    const std::string out = in.folder.path();
    const std::vector<std::vector<std::string>> commands = {
        {"export", in.design, "--to", "glsl", "-o", in.design},
        {"export", in.design, "--to", "glsl", "-o", in.picture},
        {"export", in.design, "--to", "glsl", "-o",
         out + "/../" + in.folder.path().filename().string() + "/d.nacre"},
        {"export", in.design, "--to", "exr", "-o", out},
        {"bake", in.design, "-o", out},
        {"plot", in.design, "-o", out + "/soft.svg"},
        {"render", in.design, "-o", out + "/hard.png"},
        {"render", in.design, "-o", in.picture},
        {"render", in.other, "-o", in.environment, "--environment", in.environment},
        {"render", in.other, "-o", out + "/d.png", "--compare", in.design},
        {"screenshot", in.design, "-o", out + "/hard.png"},
        {"screenshot", in.other, "-o", out + "/./sky.png", "--script", in.script},
        {"screenshot", "-o", out + "/events.png", "--script", in.script},
        {"gallery", out, "-o", out},
        {"gallery", out, "-o", out + "/../" + in.folder.path().filename().string()},
    };
    for (const std::vector<std::string>& command : commands) {
        const Finished finished = run_cli(command);
        CAPTURE(finished.err);
        CAPTURE(command.front());
        CHECK(finished.code == 1);
        CHECK(finished.out == "");
        CHECK(is_one_line_with(finished.err, {": write: ", "overwrite", " (", out}));
        CHECK(in.contents() == in.before);
    }
    fs::copy_file(in.object, in.folder / "o.png");
    fs::remove(in.object);
    fs::create_hard_link(in.folder / "o.png", in.object);
    CHECK(run_cli({"render", in.other, "-o", in.folder / "o.png", "--object", in.object}).code == 1);
    CHECK(in.contents() == in.before);
}

TEST_CASE("a design that comes through a redirection is not overwritten either") {
    const Inputs in;
    const Finished finished =
        run_cli({"export", "-", "--to", "glsl", "-o", in.other}, {.input_from = in.other});
    CHECK(finished.code == 1);
    CHECK_MESSAGE(is_one_line_with(finished.err, {"overwrite"}), finished.err);
    CHECK(in.contents() == in.before);
}

TEST_CASE("a gallery's pictures and its contact sheet are all there, whatever the designs are called") {
    const TemporaryFolder folder, output;
    for (const char* name : {"a", "A", "contact-sheet", "contact-sheet-2"})
        save_design(design_of(GaussianLobe{}), folder / (std::string(name) + ".nacre"));
    CHECK(
        answer({"gallery", folder.path(), "-o", output.path(), "--size", "32x32"}).starts_with("4 pictures"));
    CHECK(output.size() == 5);
    for (const char* name : {"a.png", "A.png", "contact-sheet-2.png", "contact-sheet-3.png"})
        CHECK(load_picture(output / name, "", "").width == 32);
    CHECK(load_picture(output / "contact-sheet.png", "", "", PictureShape::any).width > 32);
}

TEST_CASE("a report of two designs of one name has charts of both") {
    const TemporaryFolder folder, output;
    fs::create_directory(folder / "sub");
    for (const char* name : {"a.nacre", "sub/a.nacre"}) save_design(design_of(GgxLobe{}), folder / name);
    const std::string text = answer(
        {"report", folder / "a.nacre", folder / "sub/a.nacre", "-o", output.path(), "--longest", "1e-6"});
    CHECK(text.starts_with("4 charts"));
    for (const char* name : {"a-g.svg", "a-R.svg", "a-2-g.svg", "a-2-R.svg"})
        CHECK(fs::exists(output / name));
    write_all(folder / "report.csv", "");
    fs::remove(folder / "a.nacre");
    fs::create_hard_link(folder / "sub/a.nacre", output / "b.nacre");
    fs::remove(output / "report.md");
    fs::create_hard_link(output / "b.nacre", output / "report.md");
    const std::string before = read_all(output / "b.nacre");
    const Finished finished = run_cli({"report", folder / "sub/a.nacre", "-o", output.path()});
    CHECK(finished.code == 1);
    CHECK_MESSAGE(is_one_line_with(finished.err, {"report.md: write: ", "overwrite"}), finished.err);
    CHECK(read_all(output / "report.md") == before);
}

TEST_CASE("-o=FILE means FILE, as --output=FILE does") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    for (const std::string& option : {std::string("-o="), std::string("--output="), std::string("-o")}) {
        answer({"export", design.path(), "--to", "glsl", option + (folder / "a.glsl").string()});
        CHECK(folder.size() == 1);
        CHECK(fs::remove(folder / "a.glsl"));
    }
    const Finished empty = run_cli({"export", design.path(), "--to", "glsl", "-o=", folder / "a.glsl"});
    CHECK(empty.code == 2);
    CHECK_MESSAGE(is_one_line_with(empty.err, {"-o="}), empty.err);
    for (const std::string& option : {std::string("--output="), std::string("-o")})
        CHECK(run_cli({"export", design.path(), "--to", "glsl", option, ""}).code == 2);
    CHECK(folder.size() == 0);
}
