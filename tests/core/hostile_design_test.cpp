#include <doctest/doctest.h>
#include <fmt/core.h>
#include <sys/stat.h>

#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

std::string error_of(std::string_view text) {
    return user_error_of([&] { parse_design(text, "hostile.nacre", fs::temp_directory_path()); });
}

// The text must be refused at `where`, and the line must hold `part`.
void refuse(std::string_view text, std::string_view where, std::string_view part) {
    const std::string line = error_of(text);
    CAPTURE(text.substr(0, 200));
    CAPTURE(line);
    CHECK(line.starts_with(fmt::format("hostile.nacre: {}: ", where)));
    CHECK(line.find(part) != std::string::npos);
}

void accept(std::string_view text) {
    CAPTURE(text.substr(0, 200));
    CHECK(error_of(text) == "");
}

std::string design_with(std::string_view keys) { return fmt::format("{{\"nacre\": 1, {}}}", keys); }

std::string layers(std::string_view text) {
    return design_with(fmt::format("\"distribution\": {{\"layers\": [{}]}}", text));
}

std::string times(std::string_view text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

constexpr std::string_view layer_0 = "distribution.layers[0].";

void refuse_layer(std::string_view keys, std::string_view key, std::string_view part) {
    refuse(layers(fmt::format("{{{}}}", keys)), std::string(layer_0) + std::string(key), part);
}

void accept_layer(std::string_view keys) { accept(layers(fmt::format("{{{}}}", keys))); }

}  // namespace

TEST_SUITE("hostile design") {
    TEST_CASE("hostile design: broken JSON names its line and column") {
        refuse("", "line 1, column 1", "the file is empty");
        refuse("{\"nacre\": 1", "line 1, column 12", "end of the file");
        refuse("{\n  \"nacre\": 1,\n  \"näme\" 2}", "line 3, column 10", "expected ':'");
        refuse("{\"nacre\": 1} x", "line 1, column 14", "syntax error");
        refuse("{\"nacre\": 1,}", "line 1, column 13", "expected string literal");
        refuse("{\"nacre\": NaN}", "line 1, column 11", "invalid literal");
        refuse("{\"nacre\": 1, \"name\": \"a\nb\"}", "line 1, column 24", "control character");
        refuse("{\"nacre\": 1, \"name\": \"\xFF\"}", "line 1, column 23", "invalid string");
        refuse("{\"nacre\": 1, \"name\": \"\\ud800\"}", "line 1, column 29", "surrogate");
        refuse("{\"nacre\": 1} // note", "line 1, column 14", "syntax error");
        refuse(std::string_view("\0\0\0\0", 4), "line 1, column 1", "a zero byte");
        refuse("\xEF\xBB\xBF{\"nacre\": }", "line 1, column 11", "unexpected '}'");
        refuse(std::string_view("{\"nacre\": 1}\n\0x", 15), "line 2, column 1", "a zero byte");
        accept("\xEF\xBB\xBF{\"nacre\": 1}\r\n");
    }

    TEST_CASE("hostile design: nesting and sizes that no design has") {
        const std::string brackets = times("[", 200'000);
        refuse(brackets, times("[0]", 32), "nested deeper than 32 levels");
        refuse(brackets + times("]", 200'000), times("[0]", 32), "nested deeper than 32 levels");
        refuse(times("{\"a\":", 200'000), "a" + times(".a", 31), "nested deeper than 32 levels");
        refuse(design_with("\"a\": [" + times("{},", 60'000) + "{}]"), "a[49996]",
               "more than any design has");
        refuse(design_with("\"a\": [" + times("1,", 1024 * 1024) + "1]"), "a[1048576]",
               "at most 1048576 values");
    }

    TEST_CASE("hostile design: the version") {
        accept("{\"nacre\": 1}");
        refuse("{}", "nacre", "missing");
        accept("{\"nacre\": 2}");
        refuse("{\"nacre\": 3, \"new\": 1}", "nacre",
               "made by a newer Nacre (version 3): this one reads versions 1 to 2");
        refuse("{\"nacre\": 0}", "nacre", "whole number");
        refuse("{\"nacre\": 1.5}", "nacre", "whole number");
        refuse("{\"nacre\": \"1\"}", "nacre", "(\"1\")");
        refuse("[]", "design", "must be an object, {...} (a list of 0)");
        refuse("7", "design", "must be an object");
    }

    TEST_CASE("hostile design: unknown and repeated keys") {
        refuse(design_with("\"nmae\": \"\""), "nmae", "not a key of a design, which has nacre, name, note");
        refuse(design_with("\"a b\\n\": 1"), "[\"a b\\n\"]", "not a key");
        refuse(design_with("\"name\": \"\", \"name\": \"\""), "name", "this key stands twice");
        refuse(layers("{}, {\"weight\": 1, \"weight\": 1}"), "distribution.layers[1].weight", "twice");
        refuse_layer("\"lobe\": \"ggx\", \"sigma_x\": 0.1", "sigma_x", "the lobe \"ggx\"");
        refuse_layer("\"lobe\": \"uniform\", \"image\": \"a.png\"", "image", "the lobe \"uniform\"");
        refuse(design_with("\"shadowing\": {\"model\": \"uncorrelated\", \"width\": 15}"), "shadowing.width",
               "not a key of the shadowing model \"uncorrelated\"");
        refuse(design_with("\"fresnel\": {\"model\": \"dielectric\", \"f0\": [0, 0, 0]}"), "fresnel.f0",
               "not a key");
        refuse(design_with("\"diffuse\": {\"model\": \"metal\", \"albedo\": [0, 0, 0]}"), "diffuse.albedo",
               "not a key");
        refuse(design_with("\"distribution\": {\"layer\": []}"), "distribution.layer",
               "which has mean_cosine_scale, layers");
        refuse(design_with(fmt::format("\"{}\": 1", times("k", 100'000))), times("k", 40) + "...",
               "not a key");
    }

    TEST_CASE("hostile design: wrong types") {
        refuse(design_with("\"name\": 7"), "name", "must be a text (7)");
        refuse(design_with("\"note\": null"), "note", "must be a text (null)");
        refuse(design_with("\"distribution\": []"), "distribution", "must be an object");
        refuse(design_with("\"distribution\": {\"layers\": {}}"), "distribution.layers",
               "list of 1 to 16 layers");
        refuse(layers("1"), "distribution.layers[0]", "must be an object, {...} (1)");
        refuse_layer("\"lobe\": 1", "lobe", "must be one of \"gaussian\", \"inverse_gaussian\"");
        refuse_layer("\"lobe\": \"phong\"", "lobe", "(\"phong\")");
        refuse_layer("\"enabled\": 1", "enabled", "must be true or false (1)");
        refuse_layer("\"sigma_x\": \"wide\"", "sigma_x", "from 1e-05 to 100000 or \"infinity\" (\"wide\")");
        refuse_layer("\"sigma_x\": true", "sigma_x", "(true)");
        refuse_layer("\"modulation\": 1", "modulation", "must be an object");
        refuse(design_with("\"fresnel\": {\"f0\": 0.5}"), "fresnel.f0", "three numbers");
        refuse(design_with("\"fresnel\": {\"f0\": [0.5, 0.5]}"), "fresnel.f0", "(a list of 2)");
        refuse(design_with("\"fresnel\": {\"f0\": [0.5, null, 0.5]}"), "fresnel.f0[1]", "(null)");
        refuse(design_with("\"shadowing\": {\"clamp\": \"yes\"}"), "shadowing.clamp", "(\"yes\")");
    }

    TEST_CASE("hostile design: widths") {
        for (const char* width : {"0", "-1", "1e-6", "1e6", "1e-400"}) {
            refuse_layer(fmt::format("\"sigma_x\": {}", width), "sigma_x", "from 1e-05 to 100000");
            refuse_layer(fmt::format("\"lobe\": \"inverse_gaussian\", \"sigma\": {}", width), "sigma",
                         "must be");
            refuse_layer(fmt::format("\"lobe\": \"ggx\", \"alpha_x\": {}", width), "alpha_x", "must be");
            refuse_layer(fmt::format("\"lobe\": \"beckmann\", \"alpha_y\": {}", width), "alpha_y", "must be");
        }
        refuse_layer("\"sigma_y\": 1e999", "sigma_y", "(1e999)");
        refuse_layer("\"sigma_y\": -1e999", "sigma_y", "(-1e999)");
        accept_layer("\"sigma_x\": 1e-5, \"sigma_y\": \"infinity\"");
        refuse_layer("\"lobe\": \"ggx\", \"alpha_x\": \"infinity\"", "alpha_x", "(\"infinity\")");
        refuse_layer("\"lobe\": \"inverse_gaussian\", \"sigma\": \"infinity\"", "sigma", "(\"infinity\")");
    }

    TEST_CASE("hostile design: ranges") {
        refuse_layer("\"weight\": -0.1", "weight", "from 0 to 1e+30 (-0.1)");
        refuse_layer("\"weight\": 1e31", "weight", "(1e+31)");
        refuse_layer("\"tilt\": -1", "tilt", "from 0 to 180");
        refuse_layer("\"tilt\": 181", "tilt", "(181)");
        refuse_layer("\"azimuth\": 361", "azimuth", "from -360 to 360");
        refuse_layer("\"rotation\": -361", "rotation", "(-361)");
        refuse(design_with("\"distribution\": {\"mean_cosine_scale\": 0}"), "distribution.mean_cosine_scale",
               "(0)");
        refuse(design_with("\"shadowing\": {\"model\": \"correlated\", \"width\": 0}"), "shadowing.width",
               "0.1 to 180");
        refuse(design_with("\"fresnel\": {\"f0\": [0, 1.0001, 0]}"), "fresnel.f0[1]", "from 0 to 1 (1.0001)");
        refuse(design_with("\"fresnel\": {\"model\": \"dielectric\", \"ior\": 0.9}"), "fresnel.ior",
               "from 1 to 10");
        refuse(design_with("\"fresnel\": {\"model\": \"conductor\", \"eta\": [0, 1, 1]}"), "fresnel.eta[0]",
               "0.001");
        refuse(design_with("\"fresnel\": {\"model\": \"conductor\", \"k\": [1, 1, -1]}"), "fresnel.k[2]",
               "(-1)");
        refuse(design_with("\"diffuse\": {\"model\": \"coupled\", \"albedo\": [2, 0, 0]}"),
               "diffuse.albedo[0]", "(2)");
    }

    TEST_CASE("hostile design: no facets, or as many down as up") {
        refuse(layers(""), "distribution.layers", "1 to 16 layers (a list of 0)");
        accept(layers(times("{},", 15) + "{}"));
        refuse(layers(times("{},", 16) + "{}"), "distribution.layers", "(a list of 17)");
        refuse(layers("{\"weight\": 0}, {\"weight\": 0.0}"), "distribution.layers",
               "every enabled weight is 0");
        refuse(layers("{\"enabled\": false}"), "distribution.layers", "no enabled layer");
        refuse(layers("{\"enabled\": false}, {\"weight\": 0}"), "distribution.layers", "above 0");
        const std::string sphere = "{\"lobe\": \"uniform\", \"domain\": \"sphere\"}";
        refuse(layers(sphere), "distribution.layers", "N = 0");
        refuse(layers(sphere + ", {\"weight\": 0}"), "distribution.layers", "N = 0");
        refuse(layers(sphere + ", {\"enabled\": false}"), "distribution.layers", "N = 0");
        accept(layers(sphere + ", {}"));
    }

    TEST_CASE("hostile design: work that holds no facets for now comes back as it was saved") {
        Design design;
        design.distribution.layers[0].enabled = false;
        CHECK(parse_work(design_json(design, "/"), "work.nacre", "/") == design);
        CHECK_FALSE(error_of(design_json(design, "/")).empty());
    }

    TEST_CASE("hostile design: materials") {
        refuse(design_with("\"diffuse\": {\"model\": \"velvet\"}"), "diffuse.model", "\"coupled\"");
        refuse(design_with("\"diffuse\": {\"model\": \"lambertian\", \"kd\": 0.6, \"ks\": 0.5}"), "diffuse",
               "kd + ks must not exceed 1");
        accept(design_with("\"diffuse\": {\"model\": \"lambertian\", \"kd\": 0.7, \"ks\": 0.3000000001}"));
    }

    TEST_CASE("hostile design: curves") {
        const auto curve = [](std::string_view points) {
            return fmt::format("\"lobe\": \"curve\", \"points\": {}", points);
        };
        accept_layer(curve("[[0, 1], [180, 0]]"));
        refuse_layer(curve("[]"), "points", "2 to 256 points");
        refuse_layer(curve("[[0, 1]]"), "points", "(a list of 1)");
        refuse_layer(curve("[" + times("[0, 1],", 299) + "[0, 1]]"), "points[1][0]", "must rise");
        refuse_layer(curve("[[10, 1], [5, 1]]"), "points[1][0]", "here above 10 (5)");
        refuse_layer(curve("[[10, 1], [10, 0]]"), "points[1][0]", "must rise");
        refuse_layer(curve("[[-1, 1], [5, 1]]"), "points[0][0]", "from 0 to 180 (-1)");
        refuse_layer(curve("[[0, 1], [181, 1]]"), "points[1][0]", "(181)");
        refuse_layer(curve("[[0, -1], [5, 1]]"), "points[0][1]", "(-1)");
        refuse_layer(curve("[[0, 0], [5, 0]]"), "points", "a value above 0");
        refuse_layer(curve("[[0, 1], 5]"), "points[1]", "[theta, value] (5)");
        refuse_layer(curve("[[0, 1], [5, 1, 1]]"), "points[1]", "(a list of 3)");
        refuse_layer(curve("[[0, 1], [5, \"1\"]]"), "points[1][1]", "(\"1\")");
        std::string many;
        for (int i = 0; i < 257; ++i) many += fmt::format("{}[{}, 1]", i ? ", " : "", i / 2.0);
        refuse_layer(curve("[" + many + "]"), "points", "(a list of 257)");
    }

    TEST_CASE("hostile design: rasters") {
        const auto painted = [](std::string_view image) {
            return fmt::format("\"lobe\": \"painted\", \"image\": {}", image);
        };
        accept_layer(painted(R"({"width": 2, "height": 2, "values": [0, 0, 0, 1]})"));
        refuse_layer("\"lobe\": \"painted\"", "image", "missing: a picture");
        refuse_layer("\"modulation\": {\"strength\": 1}", "modulation.image", "missing");
        refuse_layer(painted("7"), "image", "path of a picture, or a raster");
        refuse_layer(painted("\"\""), "image", "path of a picture");
        refuse_layer(painted("\"a\\u0000b\""), "image", "path of a picture");
        refuse_layer(painted("{}"), "image.width", "missing");
        refuse_layer(painted(R"({"width": 2, "values": []})"), "image.height", "missing");
        refuse_layer(painted(R"({"width": 2, "height": 2})"), "image.values", "missing");
        refuse_layer(painted(R"({"width": 0, "height": 0, "values": []})"), "image.width",
                     "from 1 to 1024 (0)");
        refuse_layer(painted(R"({"width": 2.5, "height": 2, "values": []})"), "image.width", "(2.5)");
        refuse_layer(painted(R"({"width": 1e9, "height": 1e9, "values": []})"), "image.width",
                     "whole number");
        refuse_layer(painted(R"({"width": 2, "height": 1, "values": [1, 1]})"), "image.height",
                     "is square (1)");
        refuse_layer(painted(R"({"width": 2, "height": 2, "values": [1]})"), "image.values",
                     "4 numbers (a list of 1)");
        refuse_layer(painted(R"({"width": 1, "height": 1, "values": [-1]})"), "image.values[0]", "(-1)");
        refuse_layer(painted(R"({"width": 1, "height": 1, "values": [1e39]})"), "image.values[0]", "(1e+39)");
        refuse_layer(painted(R"({"width": 1, "height": 1, "values": [null]})"), "image.values[0]", "(null)");
        refuse_layer(painted(R"({"width": 1, "height": 1, "values": [1], "x": 1})"), "image.x", "not a key");
        const std::string black = R"({"width": 1, "height": 1, "values": [0]})";
        refuse_layer(painted(black), "image", "all black");
        refuse_layer("\"modulation\": {\"image\": " + black + "}", "modulation.image", "all black");
        accept_layer("\"modulation\": {\"strength\": 0.5, \"image\": " + black + "}");
        refuse_layer("\"modulation\": {\"strength\": 1.5, \"image\": " + black + "}", "modulation.strength",
                     "(1.5)");
        accept(layers("{}, {\"enabled\": false, " + painted(black) + "}"));
    }

    TEST_CASE("hostile design: pictures beside the design") {
        const TemporaryFolder folder;
        write_all(folder / "text.png", "no picture\nat all");
        REQUIRE(mkfifo((folder / "pipe.png").c_str(), 0600) == 0);
        for (const char* name : {"missing.png", "text.png", "pipe.png", ".", "/dev/zero", "new\\nline.png"}) {
            const std::string text = layers(fmt::format(R"({{"lobe": "painted", "image": "{}"}})", name));
            write_all(folder / "a.nacre", text);
            const std::string line = user_error_of([&] { load_design(folder / "a.nacre"); });
            CHECK(line.starts_with((folder / "a.nacre").string() + ": distribution.layers[0].image: "));
        }
    }

    TEST_CASE("hostile design: what cannot be opened") {
        const TemporaryFolder folder;
        const auto error_of_loading = [](const fs::path& file) {
            return user_error_of([&] { load_design(file); });
        };
        CHECK(error_of_loading(folder / "no.nacre").find(": open: ") != std::string::npos);
        CHECK(error_of_loading(folder / "no.nacre").find("No such file") != std::string::npos);
        CHECK(error_of_loading(folder / "line\nbreak").find("line\\nbreak: open: ") != std::string::npos);
        CHECK(error_of_loading(folder.path()).find("a directory") != std::string::npos);
        CHECK(error_of_loading("/dev/zero").find("not a regular file") != std::string::npos);
        REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
        CHECK(error_of_loading(folder / "pipe").find("not a regular file") != std::string::npos);
        write_all(folder / "empty.nacre", "");
        CHECK(error_of_loading(folder / "empty.nacre").find("line 1, column 1: ") != std::string::npos);
        write_all(folder / "big.nacre", "{");
        fs::resize_file(folder / "big.nacre", limits::file_bytes_max + 1);
        CHECK(error_of_loading(folder / "big.nacre").find("268435457 bytes") != std::string::npos);
    }

    TEST_CASE("hostile design: what was found is shortened and kept on one line") {
        const std::string line =
            error_of(layers(fmt::format("{{\"lobe\": \"{}\"}}", times("\\n\\u001b", 50'000))));
        CHECK(line.find("\\n\\u001b\\n") != std::string::npos);
        CHECK(line.size() < 600);
        CHECK(one_line("a\nb\x7F\xC2\x85\xE2\x80\xA8\xFF é") == "a\\nb\\u007f\\u0085\\u2028\\xff é");
        CHECK(one_line("éééé", 2) == "éé...");
    }
}
