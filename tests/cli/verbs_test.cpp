#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/image/picture.h"
#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"

using namespace nacre;
using namespace nacre::test;

TEST_CASE("info tells layers, moments, tables, shader parts and what is left out") {
    Design model = design_of(GaussianLobe{0.1, 0.3});
    Layer base = layer_of(GgxLobe{0.5, 0.5});
    base.name = "base";
    base.weight = 3;
    Layer unused = layer_of(GaussianLobe{});
    unused.enabled = false;
    model.distribution.layers.push_back(base);
    model.distribution.layers.push_back(unused);
    model.diffuse = CoupledDiffuse{};
    model.note = "two lobes";
    const DesignOnDisk design(model);
    const auto info = nlohmann::json::parse(answer({"info", design.path(), "--json"}));
    CHECK(info.at("name") == "test");
    CHECK(info.at("note") == "two lobes");
    CHECK(info.at("layers").at(0).at("share") == 0.25);
    CHECK(info.at("layers").at(1).at("name") == "base");
    CHECK(info.at("layers").at(2).at("share") == 0);
    CHECK(info.at("symmetry") == "quarter");
    CHECK(info.at("N").get<double>() > 0.5);
    CHECK(info.at("tables").size() == 2);
    CHECK(info.at("tables").at(1).at("name") == "albedo");
    CHECK(info.at("tolerance") == 1e-3);
    CHECK(info.at("table_bytes").get<int>() <= 65536);
    CHECK(info.at("g").at("worst").get<double>() < 1e-3);
    CHECK(info.at("g").at("tried").size() >= 1);
    CHECK(info.at("left_out").size() > 3);
    const std::string text = answer({"info", design.path()});
    for (const char* part :
         {"test", "two lobes", "25.0 %", "75.0 %", "symmetry  quarter", "lobe ggx", "left out"})
        CHECK(text.find(part) != std::string::npos);
}

TEST_CASE("bake tells times, sizes and errors, and the tables do not depend on the number of threads") {
    const TemporaryFolder folder;
    Design model = design_of(GaussianLobe{0.1, 0.3});
    model.fresnel = SchlickFresnel{};
    const DesignOnDisk design(model);
    const auto summary = nlohmann::json::parse(
        answer({"bake", design.path(), "-o", folder / "one", "--threads", "1", "--json"}));
    CHECK(summary.at("seconds").get<double>() > 0);
    CHECK(summary.at("errors").at("against_exact").at("g").at("worst").get<double>() < 1e-3);
    CHECK(summary.at("errors").at("against_exact").at("R").at("worst").get<double>() < 3e-3);
    answer({"export", design.path(), "--to", "exr", "-o", folder / "deep/er/many"});
    for (const auto& table : summary.at("tables")) {
        const std::string file = table.at("file");
        CHECK(read_all(folder.path() / "one" / file) == read_all(folder.path() / "deep/er/many" / file));
        CHECK(read_all(folder.path() / "one" / file) != "");
    }
}

TEST_CASE("render writes PNG and EXR of the asked size") {
    const TemporaryFolder folder;
    Design model = design_of(GaussianLobe{0.3, 0.3});
    model.diffuse = LambertianDiffuse{};
    const DesignOnDisk design(model);
    for (const char* name : {"a.png", "a.exr"}) {
        CHECK(answer({"render", design.path(), "-o", folder / name, "--size", "64x64", "--scene", "two",
                      "--light", "-30,45", "--exposure", "-0.5"}) == "");
        const Raster raster = load_picture(folder / name, "", "");
        CHECK(raster.width == 64);
        CHECK(raster.values[32 * 64 + 32] > 0.01f);
    }
    CHECK(folder.size() == 2);
}

TEST_CASE("screenshot draws the window, also after a script") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    write_all(folder / "script", "move 10 10\nframes 2\n");
    answer({"screenshot", design.path(), "-o", folder / "a.png", "--size", "400x400", "--script",
            folder / "script", "--ui-scale", "0.75"});
    CHECK(load_picture(folder / "a.png", "", "").width == 400);
    write_all(folder / "script", "move 10 10\nnonsense\n");
    const Finished wrong = run_cli({"screenshot", "-o", folder / "b.png", "--script", folder / "script"});
    CHECK(wrong.code == 1);
    CHECK_MESSAGE(is_one_line_with(wrong.err, {"script: line 2"}), wrong.err);
}

TEST_CASE("gallery renders what it can, reports the rest, and makes a contact sheet") {
    const TemporaryFolder folder, output;
    save_design(design_of(GaussianLobe{}), folder / "b.nacre");
    save_design(design_of(GgxLobe{}), folder / "a.nacre");
    write_all(folder / "readme.txt", "no design");
    const std::vector<std::string> arguments = {"gallery",      folder.path(), "-o",
                                                output / "new", "--size",      "32x32"};
    CHECK(answer(arguments).starts_with("2 pictures"));
    for (const char* name : {"new/a.png", "new/b.png", "new/contact-sheet.png"})
        CHECK(std::filesystem::exists(output.path() / name));
    write_all(folder / "c.nacre", "{");
    const Finished finished = run_cli(arguments);
    CHECK(finished.code == 1);
    CHECK(finished.out.starts_with("2 pictures"));
    CHECK_MESSAGE(is_one_line_with(finished.err, {"c.nacre: line 1"}), finished.err);
}

TEST_CASE("a gallery of many designs makes several contact sheets, and a long name is cut short") {
    const TemporaryFolder folder, output;
    Design design = design_of(GaussianLobe{});
    design.diffuse = NoDiffuse{};
    design.name = std::string(40000, 'n');
    for (int i = 0; i < 66; ++i) save_design(design, folder / fmt::format("{:02}.nacre", i));
    CHECK(answer({"gallery", folder.path(), "-o", output.path(), "--size", "32x32"})
              .starts_with("66 pictures and 2 contact sheets"));
    const Raster first = load_picture(output / "contact-sheet.png", "", "", PictureShape::any);
    const Raster second = load_picture(output / "contact-sheet-2.png", "", "", PictureShape::any);
    CHECK(output.size() == 68);
    CHECK(first.width > 3 * second.width);
}

TEST_CASE("export --to glsl writes the function") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    answer({"export", design.path(), "--to", "glsl", "-o", folder / "a.glsl"});
    CHECK(read_all(folder / "a.glsl").find("vec3 nacre_brdf(vec3 k1, vec3 k2)") != std::string::npos);
    answer({"export", design.path(), "--to", "glsl", "-o", folder / "b.glsl", "--prefix", "satin"});
    CHECK(read_all(folder / "b.glsl").find("vec3 satin_brdf(vec3 k1, vec3 k2)") != std::string::npos);
    CHECK(read_all(folder / "b.glsl").find("nacre_") == std::string::npos);
    for (const char* prefix : {"", "2nd", "a b", "a__b", "gl_a", "satin_", "satin-1", "s\xC3\xA4"})
        CHECK(run_cli({"export", design.path(), "--to", "glsl", "-o", folder / "c.glsl", "--prefix", prefix})
                  .code == 2);
    CHECK(run_cli({"export", design.path(), "--to", "exr", "-o", folder / "c", "--prefix", "a"}).code == 2);
    CHECK(folder.size() == 2);
    const std::string list = answer({"export", "--list"});
    CHECK(list.find("exr") != std::string::npos);
    CHECK(list.find("glsl") != std::string::npos);
}

TEST_CASE("export --list --json and what a format refuses") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{0.1, 0.4}));
    const auto list = nlohmann::json::parse(answer({"export", "--list", "--json"}));
    CHECK(list.size() > 10);
    CHECK(run_cli({"export", "--json"}).code == 2);
    const Finished refused = run_cli({"export", design.path(), "--to", "merl", "-o", folder / "a.binary"});
    CHECK(refused.code == 1);
    CHECK(refused.err.find("the format cannot hold: anisotropic p") != std::string::npos);
    CHECK(run_cli({"export", design.path(), "--to", "c", "-o", folder / "a.h", "--error", "0.1"}).code == 2);
    CHECK(run_cli({"export", design.path(), "--to", "glsl-samplers", "-o", "-"}).code == 1);
    CHECK(folder.size() == 0);
    answer({"export", design.path(), "--to", "glsl-samplers", "-o", folder / "a.glsl"});
    CHECK(read_all(folder / "a.f32").size() % 4096 == 0);
    CHECK(folder.size() == 2);
}

TEST_CASE("fit tells what its lobes misplace and writes them") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(BeckmannLobe{}));
    const std::string told = answer({"fit", design.path(), "--lobes", "1", "-o", folder / "a.json"});
    CHECK(told.find("% of the energy misplaced") != std::string::npos);
    const auto file = nlohmann::json::parse(read_all(folder / "a.json"));
    CHECK(file.at("lobes").size() == 1);
    CHECK(file.at("misplaced") < 0.05);
    CHECK(file.at("family") == "beckmann");
    CHECK(run_cli({"fit", design.path(), "--lobes", "65"}).code == 2);
    CHECK(run_cli({"fit", design.path(), "--target", "standard", "--weights", "view"}).code == 2);
    CHECK(run_cli({"fit", design.path(), "-o", design.path()}).code == 1);
}

TEST_CASE("export tells the next steps on standard error, to a terminal or where it is asked to") {
    const TemporaryFolder folder;
    const DesignOnDisk design(design_of(GaussianLobe{}));
    const std::vector<std::string> quiet = {"export", design.path(), "--to", "glsl", "-o", folder / "a.glsl"};
    const Finished silent = run_cli(quiet);
    CHECK(silent.out.empty());
    CHECK(silent.err.empty());
    std::vector<std::string> verbose = quiet;
    verbose.insert(verbose.end(), {"--prefix", "satin", "--verbose"});
    const Finished told = run_cli(verbose);
    CHECK(told.code == 0);
    CHECK(told.out.empty());
    CHECK(told.err.starts_with("wrote " + (folder / "a.glsl").string() + "\n1. Paste a.glsl into "));
    CHECK(told.err.find("\n3. Add satin_brdf(") != std::string::npos);
    // What goes to a stream is no file to tell of.
    CHECK(run_cli({"export", design.path(), "--to", "glsl", "-o", "-", "--verbose"}).err.empty());
}

TEST_CASE("plot writes a drawing or numbers, and its R is that of tables") {
    const TemporaryFolder folder;
    Design model = design_of(GgxLobe{0.3, 0.3});
    model.fresnel = SchlickFresnel{};
    const DesignOnDisk design(model);
    answer({"plot", design.path(), "--what", "slice", "--term", "P1", "-o", folder / "a.svg"});
    CHECK(read_all(folder / "a.svg").find("</svg>") != std::string::npos);
    answer({"plot", design.path(), "-o", folder / "a.csv"});
    std::string numbers = read_all(folder / "a.csv");
    numbers.erase(0, numbers.find('\n') + 1);
    std::replace(numbers.begin(), numbers.end(), ',', ' ');
    const auto plotted = rows(numbers);
    std::string directions;
    for (const auto& row : plotted) {
        const double theta = row.at(0) * std::acos(-1.0) / 180;
        directions += fmt::format("{} 0 {}\n", std::sin(theta), std::max(std::cos(theta), 0.0));
    }
    const auto tables = rows(answer({"tables", design.path()}, directions));
    REQUIRE(tables.size() == plotted.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
        CHECK(plotted[i].at(2) == doctest::Approx(tables[i].at(2)).epsilon(1e-6));
        CHECK(plotted[i].at(3) == doctest::Approx(tables[i].at(3)).epsilon(1e-6));
    }
    const Finished wrong = run_cli({"plot", design.path(), "-o", folder / "a.pdf"});
    CHECK(wrong.code == 1);
    CHECK_MESSAGE(is_one_line_with(wrong.err, {"a.pdf", "a .svg or a .csv"}), wrong.err);
    CHECK(run_cli({"plot", design.path(), "--what", "pie", "-o", folder / "a.svg"}).code == 2);
}
