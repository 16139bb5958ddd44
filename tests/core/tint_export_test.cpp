// What exports and shaders hold of tints, and that those of a design without any have not a word of them.
#include <doctest/doctest.h>

#include "core/bake/bake.h"
#include "core/formats/glsl_export.h"
#include "core/formats/table_files.h"
#include "core/formats/table_manifest.h"
#include "core/shading/shader_variant.h"
#include "tests/core/tinted_designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr dvec3 white{1};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// All text that is made of a design.
struct Texts {
    std::string preview, glsl, manifest;
    std::vector<float> data;
    std::vector<TablePicture> pictures;
};

Texts texts_of(Design design, const Diffuse& diffuse) {
    design.diffuse = diffuse;
    const auto tables = bake(design);
    std::vector<TablePicture> pictures = table_pictures(*tables);
    std::string manifest = table_manifest(design, *tables, pictures, tables->errors);
    return {fragment_shader(variant_of(tables->shading), "surface.frag"), glsl_export(design, *tables),
            manifest.substr(0, manifest.find("\"bake_seconds\"")), tables->data, std::move(pictures)};
}

}  // namespace

TEST_SUITE_BEGIN("tint");

TEST_CASE("a design without tints has no word of them in its shader, exports and tables") {
    for (const Diffuse& diffuse : {Diffuse{NoDiffuse{}}, Diffuse{CoupledDiffuse{}}}) {
        const Texts plain = texts_of(velvet_of(white, white), diffuse);
        for (const std::string& text : {plain.preview, plain.glsl, plain.manifest})
            for (const char* word : {"tint", "TINT", "Tint", "colour_albedo"})
                CHECK_MESSAGE(!has(text, word), word);
        // A layer that has a tint and no facets is as good as none.
        Design other = velvet_of(white, white);
        other.distribution.layers.push_back(other.distribution.layers[0]);
        other.distribution.layers.back().tint = crimson;
        other.distribution.layers.back().enabled = false;
        const Texts same = texts_of(other, diffuse);
        CHECK(same.preview == plain.preview);
        CHECK(same.glsl == plain.glsl);
        CHECK(same.manifest == plain.manifest);
        CHECK(same.data == plain.data);
    }
}

TEST_CASE("a tinted design's text is that of the design without, and more") {
    const Diffuse diffuse = CoupledDiffuse{};
    const std::string plain = texts_of(velvet_of(white, white), diffuse).preview;
    const std::string tinted = texts_of(velvet(), diffuse).preview;
    CHECK(has(tinted, "facet_tint"));
    CHECK_FALSE(has(tinted, "HAS_TINT"));
    // Every line of the plain text stands in the other one, in order.
    std::size_t at = 0;
    for (std::size_t begin = 0; begin < plain.size();) {
        const std::size_t end = plain.find('\n', begin) + 1;
        if (end == 0) break;
        const std::size_t found = tinted.find(plain.substr(begin, end - begin), at);
        REQUIRE_MESSAGE(found != std::string::npos, plain.substr(begin, end - begin));
        at = found;
        begin = end;
    }
}

TEST_CASE("R of each colour is exported where tints differ, and one factor where all share it") {
    const Diffuse diffuse = CoupledDiffuse{};
    const Texts varied = texts_of(velvet(), diffuse), shared = texts_of(velvet_of(crimson, crimson), diffuse);
    const auto channels = [](const Texts& texts, const std::string& quantity) {
        for (const TablePicture& picture : texts.pictures)
            if (picture.quantity == quantity) return picture.channels.size();
        return std::size_t{0};
    };
    for (const char* quantity : {"albedo", "residual"}) {
        CHECK(channels(varied, quantity) == 3);
        CHECK(channels(shared, quantity) == 1);
    }
    CHECK(channels(varied, "A") == 1);
    CHECK(has(varied.manifest, "\"specular = q(h) F V/4\""));
    CHECK(has(varied.manifest, "\"q\": "));
    CHECK(has(shared.manifest, "\"specular = tint p(h) F V/4\""));
    CHECK(has(shared.manifest, "\"albedo_of_design\": \"R = tint (f0 R1 + (1 - f0) R0)\""));
    CHECK(has(varied.glsl, "vec3(0.7, 0.02, 0.08)"));
    CHECK(has(shared.glsl, "#define nacre_TINT_VARIES false"));
}

TEST_SUITE_END();
