// Fresnel models of version 2 in files, and their tables in what is exported.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/formats/table_files.h"
#include "core/formats/table_manifest.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design parse(const std::string& text) { return parse_design(text, "test.nacre", "/"); }

Fresnel fresnel_of(const std::string& keys) {
    return parse("{\"nacre\": 2, \"fresnel\": {" + keys + "}}").fresnel;
}

Design with(const Fresnel& fresnel) {
    Design design = design_of(GgxLobe{0.3, 0.3}, 20, 10);
    design.fresnel = fresnel;
    return design;
}

std::string text_of(const Fresnel& fresnel) { return design_json(with(fresnel), "/"); }

void refuse(const std::string& keys, std::string_view where, std::string_view part) {
    const std::string line = user_error_of([&] { fresnel_of(keys); });
    CAPTURE(line);
    CHECK(line.starts_with(fmt::format("test.nacre: fresnel{}: ", where)));
    CHECK(line.find(part) != std::string::npos);
}

const FilmFresnel stack{MeasuredFresnel{Material::copper}, {{1.5, 300}, {2.25, 40.5}}};

}  // namespace

TEST_SUITE_BEGIN("fresnel file");

TEST_CASE("models of version 2 make a file of version 2, the others one of version 1") {
    for (std::size_t i = 0; i < KindSet<Fresnel>::count; ++i) {
        const Fresnel fresnel = KindSet<Fresnel>::made(i);
        const std::string text = text_of(fresnel);
        CAPTURE(text);
        const bool newer = text.find("\"nacre\": 2,") != std::string::npos;
        CHECK(newer == (i >= 4));
        CHECK(parse(text) == with(fresnel));
    }
    CHECK(text_of(stack).find(
              R"("fresnel": {"model": "film", "over": "measured", "material": "copper", )"
              R"("stack": [{"ior": 1.5, "thickness": 300}, {"ior": 2.25, "thickness": 40.5}]})") !=
          std::string::npos);
    CHECK(text_of(CurveFresnel{{{0, {0.5, 0.25, 0}}, {90, dvec3{1}}}})
              .find(R"("fresnel": {"model": "curve", "points": [[0, 0.5, 0.25, 0], [90, 1, 1, 1]]})") !=
          std::string::npos);
}

TEST_CASE("their keys are read, and what is missing is as the model comes") {
    CHECK(fresnel_of(R"("model": "measured", "material": "silver")") ==
          Fresnel{MeasuredFresnel{Material::silver}});
    CHECK(fresnel_of(R"("model": "film", "over": "conductor", "k": [1, 2, 3], "stack": [])").index() ==
          Fresnel{FilmFresnel{}}.index());
    CHECK(fresnel_of(R"("model": "film")") == Fresnel{FilmFresnel{}});
    CHECK(
        fresnel_of(R"("model": "film", "over": "dielectric", "ior": 1.33, "stack": [{"thickness": 250}])") ==
        Fresnel{FilmFresnel{DielectricFresnel{1.33}, {{1.5, 250}}}});
    CHECK(fresnel_of(R"("model": "f82", "f0": [0.5, 0.5, 0.5], "f82": [1, 0.5, 0])") ==
          Fresnel{F82Fresnel{dvec3{0.5}, {1, 0.5, 0}}});
    CHECK(fresnel_of(R"("model": "curve", "points": [[30, 0.1, 0.2, 0.3]])") ==
          Fresnel{CurveFresnel{{{30, {0.1, 0.2, 0.3}}}}});
}

TEST_CASE("mistakes are named with their place") {
    refuse(R"("model": "measured", "material": "unobtainium")", ".material", "silver");
    refuse(R"("model": "measured", "f0": [1, 1, 1])", ".f0", "not a key");
    refuse(R"("model": "film", "over": "schlick")", ".over", "converts any model");
    refuse(R"("model": "film", "over": 3)", ".over", "\"dielectric\", \"conductor\", \"measured\"");
    refuse(R"("model": "film", "over": "dielectric", "material": "gold")", ".material", "not a key");
    refuse(R"("model": "film", "stack": {})", ".stack", "list of at most 8");
    refuse(R"("model": "film", "stack": [{"ior": 1.5, "thick": 3}])", ".stack[0].thick",
           "not a key of a film");
    refuse(R"("model": "film", "stack": [{"ior": 0.5}])", ".stack[0].ior", "from 1 to 4");
    refuse(R"("model": "film", "stack": [{}, {"thickness": -1}])", ".stack[1].thickness", "from 0 to 2000");
    refuse(R"("model": "film", "stack": [{"ior": 4, "thickness": 2000}, {"ior": 4, "thickness": 2000}])",
           ".stack", "at most 10000 nm (16000)");
    refuse(R"("model": "curve", "points": [])", ".points", "1 to 64 points");
    refuse(R"("model": "curve", "points": [[0, 1, 1]])", ".points[0]", "[theta, red, green, blue]");
    refuse(R"("model": "curve", "points": [[0, 1, 1, 2]])", ".points[0][3]", "from 0 to 1");
    refuse(R"("model": "curve", "points": [[5, 1, 1, 1], [5, 0, 0, 0]])", ".points[1][0]", "rise");
    refuse(R"("model": "f82", "f82": [0, 0, 1.5])", ".f82[2]", "from 0 to 1");
}

TEST_CASE("what is baked of a table is what the reference says") {
    for (const Fresnel& fresnel : {Fresnel{stack}, Fresnel{MeasuredFresnel{}}, Fresnel{CurveFresnel{}}}) {
        Design design = with(fresnel);
        design.diffuse = CoupledDiffuse{dvec3{0.8}};
        CAPTURE(kind_name(fresnel));
        const auto tables = bake(design);
        const Reference reference(design);
        for (const double cosine : {0.95, 0.6, 0.2, 0.04})
            CHECK(albedo_error(tables->shading, polar(cosine, 0.4), reference.albedo(polar(cosine, 0.4)), 3) <
                  1.5e-3);
    }
}

TEST_CASE("the table goes with the tables: behind them for the shader, in the manifest and the GLSL") {
    const auto tables = bake(with(stack));
    const FresnelCurve& curve = *tables->shading.fresnel_curve;
    const auto begin = static_cast<std::size_t>(tables->shading.surface.fresnel_a.x);
    REQUIRE(begin + curve.values.size() <= tables->data.size());
    CHECK(begin == tables->table_floats());
    CHECK(std::equal(curve.values.begin(), curve.values.end(),
                     tables->data.begin() + static_cast<std::ptrdiff_t>(begin)));
    const std::string manifest =
        table_manifest(with(stack), *tables, table_pictures(*tables), tables->errors);
    for (const char* part : {"\"fresnel\": \"film\"", "\"over\": \"measured\"", "\"material\": \"copper\"",
                             "\"fresnel_curve\": [", "F = fresnel_curve(sqrt(c))"})
        CHECK(manifest.find(part) != std::string::npos);
    CHECK(glsl_export(with(stack), *tables, "oil").find("oil_fetch_curve") != std::string::npos);
    const auto plain = bake(with(ConductorFresnel{}));
    CHECK(plain->data.size() == plain->table_floats());
    CHECK(plain->shading.curve == nullptr);
    CHECK(table_manifest(with(ConductorFresnel{}), *plain, table_pictures(*plain), plain->errors)
              .find("curve") == std::string::npos);
}

TEST_SUITE_END();
