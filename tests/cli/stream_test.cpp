// Standard input, output and error as they come.
#include <doctest/doctest.h>
#include <signal.h>

#include <algorithm>

#include "core/image/image_file.h"
#include "core/image/picture.h"
#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/stopping.h"

using namespace nacre;
using namespace nacre::test;

namespace {

const std::string mark = "\xEF\xBB\xBF";

}  // namespace

TEST_CASE("a byte order mark before the first line is skipped, and nowhere else") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    for (const char* verb : {"eval", "tables"}) {
        const std::string line = verb == std::string("eval") ? "0 0 1 0 0 1" : "0 0 1";
        const std::string expected = answer({verb, design.path()}, line + "\n");
        CHECK(answer({verb, design.path()}, mark + line + "\n") == expected);
        CHECK(answer({verb, design.path()}, mark + line) == expected);
        CHECK(answer({verb, design.path()}, mark + "# comment\r\n" + line + "\r\n") == expected);
        CHECK(answer({verb, design.path()}, mark) == "");
        const Finished later = run_cli({verb, design.path()}, {.input = line + "\n" + mark + line + "\n"});
        CHECK(later.code == 1);
        CHECK_MESSAGE(is_one_line_with(later.err, {"standard input: line 2"}), later.err);
    }
    const std::string text = read_all(design.path());
    CHECK(answer({"check", "-"}, mark + text) == answer({"check", design.path()}));
}

TEST_CASE("- is a design on standard input, by every verb that reads one") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const std::string text = read_all(design.path());
    CHECK(answer({"check", "-"}, text) == answer({"check", design.path()}));
    CHECK(answer({"info", "-"}, text).starts_with("test\n"));
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"export", "--to", "glsl"}, {"plot", "--format", "csv"}}) {
        std::vector<std::string> piped = options, named = options;
        piped.insert(piped.begin() + 1, {"-", "-o", "-"});
        named.insert(named.begin() + 1, {design.path(), "-o", "-"});
        CHECK(answer(piped, text) == answer(named));
        CHECK(answer(named).size() > 100);
    }
    answer({"bake", "-", "-o", folder / "tables"}, text);
    CHECK(std::filesystem::exists(folder / "tables/manifest.json"));
    answer({"screenshot", "-", "-o", folder / "a.png", "--size", "400x400"}, text);
    const Finished wrong = run_cli({"info", "-"}, {.input = "{\"nacre\": 1, \"colour\": 2}"});
    CHECK(wrong.code == 1);
    CHECK_MESSAGE(is_one_line_with(wrong.err, {"standard input: colour: "}), wrong.err);
    const Finished dark =
        run_cli({"info", "-"}, {.input = R"({"nacre": 1, "distribution": {"layers": [{"weight": 0}]}})"});
    CHECK_MESSAGE(is_one_line_with(dark.err, {"standard input: distribution"}), dark.err);
    CHECK(run_cli({"info", "-"}, {.closed = {0}}).code == 1);
}

TEST_CASE("-o - is the file on standard output and nothing besides") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const auto same_as_file = [&](std::vector<std::string> verb, const std::string& name,
                                  const std::vector<std::string>& format, const std::string& message) {
        std::vector<std::string> to_file = verb;
        to_file.insert(to_file.end(), {"-o", folder / name});
        const Finished written = run_cli(to_file);
        verb.insert(verb.end(), {"-o", "-"});
        verb.insert(verb.end(), format.begin(), format.end());
        const Finished piped = run_cli(verb);
        CHECK(piped.code == 0);
        CHECK(piped.out == read_all(folder / name));
        CHECK(written.out.starts_with(message));
        CHECK(piped.err == written.out);
    };
    const std::vector<std::string> render = {"render", design.path(), "--size", "32x32"};
    same_as_file(render, "a.png", {}, "");
    same_as_file(render, "b.png", {"--format", "png"}, "");
    same_as_file(render, "a.exr", {"--format", "exr"}, "");
    std::vector<std::string> compare = render;
    compare.insert(compare.end(), {"--compare", "ggx"});
    same_as_file(compare, "c.png", {}, "test against ");
    same_as_file({"plot", design.path(), "--what", "density"}, "a.svg", {}, "");
    same_as_file({"plot", design.path(), "--what", "density"}, "a.csv", {"--format", "csv"}, "");
    same_as_file({"export", design.path(), "--to", "glsl"}, "a.glsl", {}, "");
    same_as_file({"screenshot", design.path(), "--size", "400x400"}, "s.png", {}, "");
}

TEST_CASE("- is an environment on standard input") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    std::vector<float> rgb(32 * 16 * 3, 0.1f);
    std::fill_n(rgb.begin() + 100, 60, 4.0f);
    for (const char* name : {"sky.exr", "sky.png"}) {
        write_image(folder / name, {32, 16}, rgb);
        const std::vector<std::string> render = {
            "render", design.path(), "--size", "32x32", "--samples", "4", "-o", "-", "--environment"};
        std::vector<std::string> named = render, piped = render;
        named.push_back(folder / name);
        piped.emplace_back("-");
        CHECK(answer(piped, read_all(folder / name)) == answer(named));
        const Finished wrong = run_cli(piped, {.input = "no picture"});
        CHECK(wrong.code == 1);
        CHECK_MESSAGE(is_one_line_with(wrong.err, {"standard input: "}), wrong.err);
    }
}

TEST_CASE("- where it makes no sense is wrong usage") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"bake", design.path(), "-o", "-"},
          {"report", design.path(), "-o", "-"},
          {"report", "-", "-", "-o", "x"},
          {"gallery", "x", "-o", "-"},
          {"gallery", "-", "-o", "x"},
          {"export", design.path(), "--to", "exr", "-o", "-"},
          {"eval", "-"},
          {"tables", "-"},
          {"render", design.path(), "-o", "x.png", "--format", "png"},
          {"plot", design.path(), "-o", "-", "--format", "png"}}) {
        const Finished finished = run_cli(arguments);
        CAPTURE(finished.err);
        CHECK(finished.code == 2);
        CHECK(finished.out == "");
        CHECK(is_one_line_with(finished.err, {}));
    }
}

TEST_CASE("standard output that does not wait gets all of the answers") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    std::string lines;
    for (int i = 0; i < 20'000; ++i) lines += "0 0 1\n";
    const Finished finished = run_cli({"tables", design.path()}, {.input = lines, .output_slow = true});
    CHECK(finished.code == 0);
    CHECK(finished.err == "");
    CHECK(finished.out == answer({"tables", design.path()}, lines));
}

TEST_CASE("who cannot be told gets the right exit code all the same") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    for (const ChildOptions& options : {ChildOptions{.error_to = "/dev/full"}, ChildOptions{.closed = {2}},
                                        ChildOptions{.closed = {0, 1, 2}}}) {
        CHECK(run_cli({"info", "nofile.nacre"}, options).code == 1);
        CHECK(run_cli({"nosuchverb"}, options).code == 2);
        CHECK(run_cli({"info"}, options).code == 2);
        CHECK(run_cli({"info", design.path()}, options).code == (options.closed.size() == 3 ? 1 : 0));
    }
    const Finished unheard = run_cli({"info", design.path()}, {.closed = {1}});
    CHECK(unheard.code == 1);
    CHECK_MESSAGE(is_one_line_with(unheard.err, {"standard output: write: "}), unheard.err);
    const Finished nothing = run_cli({"tables", design.path()}, {.closed = {0}});
    CHECK(nothing.code == 1);
    CHECK_MESSAGE(is_one_line_with(nothing.err, {"standard input: read: "}), nothing.err);
}

TEST_CASE("no file is written into in place of a closed stream") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const std::vector<std::string> compare = {"render", design.path(),    "--size",    "16x16",
                                              "-o",     folder / "a.png", "--compare", "ggx"};
    CHECK(run_cli(compare).code == 0);
    const std::string picture = read_all(folder / "a.png");
    std::vector<std::string> write = {"export", design.path(), "--to", "glsl", "-o", folder / "a.glsl"};
    answer(write);
    const std::string text = read_all(folder / "a.glsl");
    std::filesystem::remove(folder / "a.glsl");
    CHECK(run_cli(write, {.closed = {0, 1, 2}}).code == 0);
    CHECK(read_all(folder / "a.glsl") == text);
    CHECK(run_cli(compare, {.closed = {1, 2}}).code == 1);  // the numbers cannot be told
    CHECK(read_all(folder / "a.png") == picture);
}

TEST_CASE("a file that may not grow is an error and no signal, and the old file stays") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    for (const char* name : {"a.png", "a.exr", "a.glsl", "a.svg"}) {
        const std::string file = folder / name;
        std::vector<std::string> verb = {"render", design.path(), "--size", "64x64", "-o", file};
        if (name == std::string("a.glsl")) verb = {"export", design.path(), "--to", "glsl", "-o", file};
        if (name == std::string("a.svg")) verb = {"plot", design.path(), "--what", "density", "-o", file};
        write_all(file, "old");
        const Finished finished = run_cli(verb, {.file_bytes_max = 500});
        CHECK(finished.code == 1);
        CHECK_MESSAGE(is_one_line_with(finished.err, {name, ": write: ", "(File too large)"}), finished.err);
        CHECK(read_all(file) == "old");
    }
    CHECK(folder.size() == 4);
    const Finished answers = run_cli({"info", design.path()}, {.file_bytes_max = 100});
    CHECK(answers.code == 1);
    CHECK_MESSAGE(is_one_line_with(answers.err, {"standard output: write: ", "(File too large)"}),
                  answers.err);
}

TEST_CASE("a terminal that goes stops the work as Ctrl+C does, unless that is ignored") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    check_stops_within_a_second({"render", design.path(), "-o", folder / "big.png", "--size", "4096x4096"},
                                {.signal = SIGHUP, .signal_after = 1});
    CHECK(folder.size() == 0);
}
