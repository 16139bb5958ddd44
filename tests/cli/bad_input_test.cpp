#include <doctest/doctest.h>

#include <filesystem>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

std::string one_layer(const std::string& layer) {
    return R"({"nacre": 1, "distribution": {"layers": [)" + layer + "]}}";
}

struct Hostile {
    std::string text;
    std::string where;
};

std::vector<Hostile> hostile_designs() {
    return {
        {"", ""},
        {"{\"nacre\": 1,", "line 1"},
        {std::string(200000, '['), "nested deeper"},
        {R"({"nacre": 3})", "newer Nacre"},
        {R"({"nacre": 1, "colour": 3})", "colour"},
        {R"({"nacre": 1, "name": 3})", "name"},
        {one_layer(R"({"lobe": "gaussian", "sigma_x": 0})"), "distribution.layers[0].sigma_x"},
        {one_layer(R"({"lobe": "gaussian", "sigma_x": -1})"), "distribution.layers[0].sigma_x"},
        {one_layer(R"({"lobe": "gaussian", "sigma_x": 1e999})"), "distribution.layers[0].sigma_x"},
        {one_layer(R"({"lobe": "gaussian", "sigma_x": NaN})"), "line 1"},
        {one_layer(R"({"lobe": "gaussian", "weight": 0})"), "distribution"},
        {one_layer(R"({"lobe": "uniform", "domain": "sphere"})"), "distribution"},
        {one_layer(R"({"lobe": "gaussian", "tilt": 90})"), "distribution"},
        {one_layer(R"({"lobe": "painted", "image": "missing.png"})"), "distribution.layers[0].image"},
        {one_layer(R"({"lobe": "painted", "image": "/dev/zero"})"), "distribution.layers[0].image"},
        {one_layer(R"({"lobe": "curve", "points": [[20, 1], [0, 1]]})"), "distribution.layers[0].points"},
        {R"({"nacre": 1, "fresnel": {"model": "schlick", "f0": [2, 0, 0]}})", "fresnel.f0"},
    };
}

// One line on standard error that names the file, exit code 1, and nothing on standard output.
void check_refused(const Finished& finished, const std::vector<std::string>& parts) {
    CHECK(finished.code == 1);
    CHECK(finished.out == "");
    CHECK_MESSAGE(is_one_line_with(finished.err, parts), finished.err);
}

}  // namespace

TEST_CASE("a hostile design is one line with file and place, whatever the verb") {
    const TemporaryFolder folder;
    const std::string file = folder / "hostile.nacre";
    for (const Hostile& hostile : hostile_designs()) {
        write_all(file, hostile.text);
        check_refused(run_cli({"eval", file}), {file + ": ", hostile.where});
    }
    for (const std::vector<std::string>& verb : {std::vector<std::string>{"info", file},
                                                 {"tables", file},
                                                 {"check", file},
                                                 {"bake", file, "-o", folder / "out"},
                                                 {"render", file, "-o", folder / "out.png"},
                                                 {"screenshot", file, "-o", folder / "out.png"},
                                                 {"export", file, "--to", "glsl", "-o", folder / "out.glsl"}})
        check_refused(run_cli(verb), {file + ": "});
    CHECK(folder.size() == 1);
    check_refused(run_cli({"info", folder / "absent.nacre"}), {"absent.nacre: open: "});
    check_refused(run_cli({"info", folder.path()}), {folder.path().string() + ": open: "});
}

TEST_CASE("usage that is wrong is exit code 2 and one line; help and version are 0") {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{},
          {"nonsense"},
          {"eval"},
          {"info", "--nonsense", "x"},
          {"render", "x.nacre"},
          {"render", "x.nacre", "-o", "x.png", "--size", "0x0"},
          {"render", "x.nacre", "-o", "x.png", "--size", "5"},
          {"render", "x.nacre", "-o", "x.png", "--scene", "moon"},
          {"render", "x.nacre", "-o", "x.png", "--light", "1"},
          {"render", "x.nacre", "-o", "x.png", "--exposure", "nan"},
          {"render", "x.nacre", "-o", "x.png", "--rotation", "inf"},
          {"render", "x.nacre", "-o", "x.png", "--brightness", "nan"},
          {"render", "x.nacre", "-o", "x.png", "--light", "nan,0"},
          {"render", "x.nacre", "-o", "x.png", "--samples", "nan"},
          {"render", "x.nacre", "-o", "x.png", "--samples", "2.5"},
          {"render", "x.nacre", "-o", "x.png", "--compare", "ggx", "--divider", "nan"},
          {"render", "x.nacre", "-o", "x.png", "--compare", "ggx", "--amplify", "nan"},
          {"screenshot", "-o", "x.png", "--ui-scale", "nan"},
          {"plot", "x.nacre", "-o", "x.svg", "--theta", "nan"},
          {"report", "x.nacre", "-o", "x", "--longest", "nan"},
          {"export", "x.nacre", "--to", "exr", "-o", "x", "--tolerance", "nan"},
          {"bake", "x.nacre", "-o", "x", "--tolerance", "-nan"},
          {"bake", "x.nacre", "-o", "x", "--tolerance", "1e-3x"},
          {"bake", "x.nacre", "-o", "x", "--tolerance", "0,001"},
          {"bake", "x.nacre", "-o", "x", "--threads", "inf"},
          {"render", "x.nacre", "-o", "x.png", "--compare", "phong"},
          {"render", "x.nacre", "-o", "x.png", "--view", "difference"},
          {"render", "x.nacre", "-o", "x.png", "--term", "q"},
          {"bake", "x.nacre", "-o", "x", "--threads", "0"},
          {"export", "x.nacre"}}) {
        const Finished finished = run_cli(arguments);
        CHECK(finished.code == 2);
        CHECK_MESSAGE(is_one_line_with(finished.err, {}), finished.err);
    }
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--help"}, {"--version"}, {"eval", "--help"}, {"export", "--list"}}) {
        const Finished finished = run_cli(arguments);
        CHECK(finished.code == 0);
        CHECK(finished.out != "");
    }
}

TEST_CASE("a verb or format that is not there is wrong usage") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    CHECK(run_cli({"import", "x.obj", "-o", "y"}).code == 2);
    const Finished format = run_cli({"export", design.path(), "--to", "klems", "-o", "x"});
    CHECK(format.code == 2);
    CHECK_MESSAGE(format.err.find("glsl") != format.err.npos, format.err);
}

TEST_CASE("an output that cannot be written is one line, exit code 1, and nothing half-written") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    write_all(folder / "file", "kept");
    const std::string in_a_file = (folder / "file").string() + "/out", nowhere = folder / "absent/out";
    for (const std::string& target : {in_a_file, std::string("/proc/nacre-out")})
        for (const std::vector<std::string>& verb :
             {std::vector<std::string>{"bake", design.path(), "-o", target},
              {"export", design.path(), "--to", "exr", "-o", target},
              {"export", design.path(), "--to", "glsl", "-o", target},
              {"render", design.path(), "--size", "16x16", "-o", target + ".png"},
              {"screenshot", design.path(), "-o", target + ".png"}})
            check_refused(run_cli(verb), {target});
    check_refused(run_cli({"render", design.path(), "--size", "16x16", "-o", nowhere + ".png"}),
                  {nowhere, "write"});
    check_refused(run_cli({"render", design.path(), "-o", folder / "out.jpg"}), {"out.jpg", ".png or .exr"});
    check_refused(run_cli({"export", design.path(), "--to", "glsl", "-o", folder.path()}), {"directory"});
    CHECK(folder.size() == 1);
    CHECK(read_all(folder / "file") == "kept");
}

TEST_CASE("standard output that fails is one line; a reader that has gone is none") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const Finished full = run_cli({"info", design.path()}, {.output_to = "/dev/full"});
    CHECK(full.code == 1);
    CHECK_MESSAGE(is_one_line_with(full.err, {"standard output: write: "}), full.err);
    const Finished gone = run_cli({"info", design.path()}, {.output_reader_gone = true});
    CHECK(gone.code == 1);
    CHECK(gone.err == "");
}
