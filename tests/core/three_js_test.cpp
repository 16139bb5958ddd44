// The exported three.js module as text.
#include "core/formats/three_js.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/bake/bake.h"
#include "core/formats/glsl_sampler.h"
#include "core/formats/web_fill.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

std::string between(const std::string& text, std::string_view begin, std::string_view end) {
    const std::size_t at = text.find(begin) + begin.size();
    return text.substr(at, text.find(end, at) - at);
}

}  // namespace

TEST_SUITE_BEGIN("three.js");

TEST_CASE("the module holds the function with a sampler and its tables, under its prefix") {
    const Design design = design_of(GgxLobe{0.2, 0.4});
    for (const bool albedo : {false, true}) {
        const auto tables = bake(design, {.quality = Quality::draft, .albedo = albedo});
        const std::string text = three_js_module(design, *tables, "my_metal", "metal.js");
        CHECK(nlohmann::json::parse(between(text, "export const glsl = ", ";\nconst rows")) ==
              glsl_sampler_text(design, *tables, "my_metal"));
        CHECK(between(text, "const packed = \"", "\"") == base64(texture_bytes(sampler_data(*tables))));
        CHECK(has(text, "my_metal_brdf(k1, viewer)"));
        CHECK(has(text, "import {material} from \"./metal.js\";"));
        CHECK(has(text, "my_metal_albedo(viewer) * ambientLightColor") == albedo);
        CHECK_FALSE(has(text, "{{"));
    }
}

TEST_CASE("a name ends no line of a comment and no text") {
    Design design = design_of(GgxLobe{0.2, 0.4});
    const auto tables = bake(design, {.quality = Quality::draft});
    design.name = "two\nlines\xE2\x80\xA8\"`${alert(1)}";
    const std::string text = three_js_module(design, *tables, "nacre", "a.js");
    const std::string line = between(text, "", "\n");
    CHECK(has(line, "u2028"));
    CHECK(has(line, "a material for three.js"));
    CHECK_FALSE(has(text, "\xE2\x80\xA8"));
}

TEST_CASE("texts are filled once, and a place without a value is a defect that shows") {
    CHECK(filled("a {{x}} b {{y}}{{x}}", {{"x", "{{y}}"}, {"y", "2"}}) == "a {{y}} b 2{{y}}");
    CHECK(filled("", {}) == "");
    CHECK_THROWS_AS(filled("{{z}}", {{"x", "1"}}), std::logic_error);
    // RFC 4648, sec. 10.
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foobar") == "Zm9vYmFy");
}

TEST_SUITE_END();
