#include <doctest/doctest.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::vector<std::string> lines_of_text(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// Every visibility, Fresnel and diffuse model at least once with every other kind of model.
std::vector<Design> every_model() {
    std::vector<Design> designs;
    const Fresnel fresnels[] = {NoFresnel{}, SchlickFresnel{}, DielectricFresnel{}, ConductorFresnel{}};
    const Diffuse diffuses[] = {NoDiffuse{}, LambertianDiffuse{}, CoupledDiffuse{}, MetalDiffuse{},
                                FacetDiffuse{}};
    for (int i = 0; i < 12; ++i) {
        Design design = design_of(GgxLobe{0.1, 0.5});
        if (i % 4 == 1) design.distribution.layers[0].tilt = 40;
        design.shadowing.clamp = i % 3 != 1;
        design.shadowing.model =
            KindSet<MaskingModel>::made(static_cast<std::size_t>(i) % KindSet<MaskingModel>::count);
        design.fresnel = fresnels[i % 4];
        design.diffuse = diffuses[(i + i / 4) % 5];
        designs.push_back(design);
    }
    return designs;
}

}  // namespace

TEST_CASE("eval of (a, b) and of (b, a) print the same characters, none negative and all finite") {
    const auto a = test_directions(300, 1), b = test_directions(300, 2);
    std::string there, back;
    for (std::size_t i = 0; i < a.size(); ++i) {
        there += line_of(a[i]) + " " + line_of(b[i] * 1e-300) + "\n";
        back += line_of(b[i] * 1e300) + " " + line_of(a[i]) + "\n";
    }
    for (const Design& model : every_model()) {
        const DesignOnDisk design(model);
        const auto lines = lines_of_text(answer({"eval", design.path()}, there + back));
        REQUIRE(lines.size() == 2 * a.size());
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(lines[i] == lines[i + a.size()]);
        for (const auto& row : rows(fmt::format("{}", fmt::join(lines, "\n"))))
            for (const double value : row) CHECK((std::isfinite(value) && value >= 0));
    }
}

TEST_CASE("eval --exact is reciprocal and close to the tables, in every term") {
    Design model = design_of(GaussianLobe{0.3, 0.3});
    model.fresnel = SchlickFresnel{};
    model.diffuse = CoupledDiffuse{};
    const DesignOnDisk design(model);
    const std::string there = "0.3 0.1 0.8 -0.5 0.2 0.4\n0.1 0 1 0 0.1 1\n";
    const std::string back = "-0.5 0.2 0.4 0.3 0.1 0.8\n0 0.1 1 0.1 0 1\n";
    for (const char* term : {"specular", "diffuse", "total"}) {
        const std::string exact = answer({"eval", design.path(), "--exact", "--term", term}, there);
        CHECK(exact == answer({"eval", design.path(), "--exact", "--term", term}, back));
        const auto from_tables = rows(answer({"eval", design.path(), "--term", term}, there));
        for (std::size_t i = 0; i < from_tables.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                CHECK(from_tables[i].at(c) == doctest::Approx(rows(exact).at(i).at(c)).epsilon(5e-3));
    }
}

TEST_CASE("the terms add up") {
    Design model = design_of(GaussianLobe{0.2, 0.2});
    model.diffuse = LambertianDiffuse{.kd = 0.4, .ks = 0.6, .albedo = {0.9, 0.5, 0.1}};
    const DesignOnDisk design(model);
    const std::string input = "0.3 0 0.9 -0.3 0.05 0.9\n";
    const auto specular = rows(answer({"eval", design.path(), "--term", "specular"}, input)).at(0);
    const auto diffuse = rows(answer({"eval", design.path(), "--term", "diffuse"}, input)).at(0);
    const auto total = rows(answer({"eval", design.path()}, input)).at(0);
    for (std::size_t c = 0; c < 3; ++c)
        CHECK(total[c] == doctest::Approx(specular[c] + diffuse[c]).epsilon(1e-8));
}

TEST_CASE("eval is 0 unless both directions stand above the horizon") {
    const DesignOnDisk design(design_of(UniformLobe{}));
    const std::string input = "1 0 0 0 0 1\n0 0 1 1 0 -0.1\n0 0 -1 0 0 1\n-1 0 0 1 0 0\n";
    CHECK(answer({"eval", design.path()}, input) == "0 0 0\n0 0 0\n0 0 0\n0 0 0\n");
}

TEST_CASE("eval answers however little above the horizon a direction stands") {
    for (std::size_t model = 0; model < KindSet<MaskingModel>::count; ++model) {
        Design uniform = design_of(UniformLobe{});
        uniform.shadowing.model = KindSet<MaskingModel>::made(model);
        const DesignOnDisk design(uniform);
        const std::string input = "1 0 1e-310 0 0 1\n1 0 1e-310 -1 0 1e-310\n1 0 1e-310 1 0 5e-324\n";
        const std::string back = "0 0 1 1 0 1e-310\n-1 0 1e-310 1 0 1e-310\n1 0 5e-324 1 0 1e-310\n";
        for (const bool exact : {false, true}) {
            std::vector<std::string> words = {"eval", design.path()};
            if (exact) words.push_back("--exact");
            const std::string there = answer(words, input);
            CHECK(there == answer(words, back));
            for (const auto& row : rows(there)) CHECK((std::isfinite(row.at(0)) && row.at(0) > 0));
        }
    }
}

TEST_CASE("eval skips blank lines and comments, takes any blanks and line ends, and keeps the order") {
    const DesignOnDisk design(design_of(GgxLobe{0.3, 0.5}));
    const std::string plain = answer({"eval", design.path()}, "0 0 1 0.1 0 1\n0 0 1 0.5 0 1\n");
    CHECK(plain == answer({"eval", design.path()},
                          "# directions\r\n\r\n 0 0 1\t+0.1 0 1 \r\n   \n  # more\n0 0 1e0 5e-1 0 1.0"));
    CHECK(answer({"eval", design.path()}, "") == "");
    std::string many, one_by_one;
    for (int i = 0; i < 3000; ++i) {
        const std::string line = fmt::format("0 0 1 {} 0 1\n", i % 7 * 0.1);
        many += line;
        if (i < 7) one_by_one += answer({"eval", design.path()}, line);
    }
    const auto lines = lines_of_text(answer({"eval", design.path()}, many));
    REQUIRE(lines.size() == 3000);
    const auto expected = lines_of_text(one_by_one);
    for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i] == expected[i % 7]);
}

TEST_CASE("lines that are no directions name their line, after the answers to the lines before") {
    const DesignOnDisk design(design_of(UniformLobe{}));
    const char* wrong[] = {"0 0 1 0 0",       "0 0 1 0 0 1 0",   "0 0 1 0 0 nan", "0 0 1 inf 0 1",
                           "0 0 0 0 0 1",     "0 0 1 0 0 1e999", "0 0 1 0 0 x",   "0,0,1,0,0,1",
                           "0 0 1 0 0 0x10 ", "0 0 1 0 0 -0 "};
    for (const std::string line : wrong) {
        const Finished finished =
            run_cli({"eval", design.path()}, {.input = "# one\n0 0 1 0 0 1\n" + line + "\n0 0 1 0 0 1\n"});
        CHECK(finished.code == 1);
        CHECK_MESSAGE(is_one_line_with(finished.err, {"standard input: line 3: "}), finished.err);
        CHECK(rows(finished.out).size() == 1);
    }
    const Finished binary = run_cli({"eval", design.path()}, {.input = std::string(200000, '\0')});
    CHECK(binary.code == 1);
    CHECK_MESSAGE(is_one_line_with(binary.err, {"standard input: line 1: "}), binary.err);
    const Finished three = run_cli({"tables", design.path()}, {.input = "0 0 1\n0 0 0\n"});
    CHECK(three.code == 1);
    CHECK_MESSAGE(is_one_line_with(three.err, {"standard input: line 2: "}), three.err);
}

TEST_CASE("a term that is not there is wrong usage") {
    const DesignOnDisk design(design_of(GaussianLobe{}));
    for (const char* term : {"facets", "nonsense"})
        CHECK(run_cli({"eval", design.path(), "--term", term}).code == 2);
}

TEST_CASE("eval --exact walks for light that bounces between facets, and tells the standard error") {
    Design model = design_of(GgxLobe{0.5, 0.5});
    model.fresnel = SchlickFresnel{{0.9, 0.6, 0.3}};
    model.multibounce = RankOneMultibounce{};
    model.diffuse = FacetDiffuse{.albedo = {0.9, 0.5, 0.2}};
    const DesignOnDisk design(model);
    const ChildOptions input{.input = "0.5 0.1 0.8 -0.6 0.2 0.7\n"};
    for (const char* term : {"multibounce", "diffuse"}) {
        const auto with = [&](const char* walks) {
            return run_cli({"eval", design.path(), "--exact", "--term", term, "--walks", walks}, input);
        };
        const Finished few = with("2048"), many = with("131072");
        REQUIRE(few.code == 0);
        CHECK(few.err.find("by 2048 walks a line: standard error at most ") != std::string::npos);
        const auto error = [](const Finished& finished) {
            return std::stod(finished.err.substr(finished.err.rfind(' ')));
        };
        CHECK(error(many) < 0.25 * error(few));
        const auto from_tables = rows(answer({"eval", design.path(), "--term", term}, input.input)).at(0);
        for (std::size_t c = 0; c < 3; ++c) {
            const double walked = rows(many.out).at(0).at(c);
            CHECK(std::fabs(walked - rows(few.out).at(0).at(c)) < 4 * (error(few) + error(many)));
            CHECK(std::fabs(walked - from_tables.at(c)) < 0.25 * walked + 3 * error(many));
        }
    }
    CHECK(run_cli({"eval", design.path(), "--walks", "10"}, input).code == 2);
}
