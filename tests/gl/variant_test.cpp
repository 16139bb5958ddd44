// Shader variants as text: each holds only what it needs, and each passes glslangValidator.
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/bake/bake.h"
#include "core/compare/closed_form.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/shading/shader_variant.h"
#include "shaders/shader_text.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

std::vector<Design> presets() {
    std::vector<Design> all;
    for (const auto& entry : fs::directory_iterator(NACRE_SOURCE_DIR "/presets"))
        if (entry.path().extension() == ".nacre") all.push_back(load_design(entry.path()));
    return all;
}

// Every kind of everything, each lobe with each model in turn.
std::vector<ShaderVariant> all_kinds() {
    std::vector<ShaderVariant> variants;
    int turn = 0;
    const int lobes = static_cast<int>(KindSet<Lobe>::count);
    for (std::size_t fresnel = 0; fresnel < KindSet<Fresnel>::count; ++fresnel)
        for (std::size_t masking = 0; masking < KindSet<MaskingModel>::count; ++masking)
            for (std::size_t diffuse = 0; diffuse < KindSet<Diffuse>::count; ++diffuse) {
                ShaderVariant variant;
                variant.lobes = {turn % lobes};
                variant.modulation = turn % 3 == 0;
                const bool reads = reads_albedo(KindSet<Diffuse>::made(diffuse));
                variant.kinds = {.fresnel = static_cast<int>(fresnel),
                                 .masking = static_cast<int>(masking),
                                 .diffuse = static_cast<int>(diffuse),
                                 .clamp = turn % 2 == 0,
                                 .albedo = reads || turn % 5 == 0,
                                 .tint = std::array{Tint::none, Tint::shared, Tint::varied}[turn / 2 % 3],
                                 .retro = turn % 7 < 3,
                                 .coat = turn % 3 % static_cast<int>(KindSet<Coat>::count)};
                variant.lights = 1 + turn % 3;
                variant.ambient = variant.kinds.albedo && turn % 4 < 2;
                variant.term = all_terms()[static_cast<std::size_t>(turn) % all_terms().size()].term;
                variants.push_back(variant);
                ++turn;
            }
    // Each model in the place of a design's own BRDF, whole and in parts.
    for (int model = 0; model < static_cast<int>(all_closed_forms().size()); ++model)
        for (const Term term : {Term::total, Term::specular, Term::diffuse}) {
            ShaderVariant variant;
            variant.lobes = {turn++ % lobes};
            variant.kinds = {.fresnel = kind_index<Fresnel, SchlickFresnel>(),
                             .diffuse = kind_index<Diffuse, CoupledDiffuse>(),
                             .albedo = true};
            variant.ambient = true;
            variant.term = term;
            variant.closed_form = model;
            variants.push_back(variant);
        }
    return variants;
}

// Writes the shaders, runs the validator once over all of them and returns what it says; empty when all is
// well.
std::string validate(const std::map<std::string, std::string>& shaders) {
    const fs::path folder = fs::temp_directory_path() / fmt::format("nacre-shaders-{}", getpid());
    fs::create_directories(folder);
    std::string files;
    for (const auto& [name, text] : shaders) {
        std::ofstream(folder / name) << text;
        files += " '" + (folder / name).string() + "'";
    }
    const std::string command = "glslangValidator" + files + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe);
    std::string output;
    char buffer[4096];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, n);
    const int status = pclose(pipe);
    fs::remove_all(folder);
    return status == 0 ? "" : output + fmt::format("exit {}", status);
}

}  // namespace

TEST_SUITE_BEGIN("variants");

TEST_CASE("glslangValidator accepts every variant") {
    std::map<std::string, std::string> shaders;
    for (const char* whole : {"full_screen.vert", "develop.frag", "mesh.vert", "outline.frag", "fill.frag"})
        shaders[whole] = std::string(shader_text(whole));
    for (const char* part : {"sphere.frag", "mesh.frag"})
        shaders[part] = std::string(shader_text("geometry.glsl")) + std::string(shader_text(part));
    int index = 0;
    for (const ShaderVariant& variant : all_kinds()) {
        shaders[fmt::format("surface-{}.frag", index)] = fragment_shader(variant, "surface.frag");
        ShaderVariant before = variant;
        before.environment_behind = true;
        shaders[fmt::format("environment-{}.frag", index)] = fragment_shader(before, "surface.frag");
        shaders[fmt::format("accumulate-{}.frag", index)] = fragment_shader(variant, "accumulate.frag");
        shaders[fmt::format("parity-{}.frag", index++)] = fragment_shader(variant, "parity.frag");
    }
    CHECK(validate(shaders) == "");
}

TEST_CASE("glslangValidator accepts every preset's variant and exported function") {
    std::map<std::string, std::string> shaders;
    int index = 0;
    for (const Design& design : presets()) {
        const auto tables = bake(design, {.quality = Quality::draft});
        shaders[fmt::format("preset-{}.frag", index)] =
            fragment_shader(variant_of(tables->shading), "surface.frag");
        shaders[fmt::format("export-{}.frag", index++)] =
            "#version 330 core\n" + glsl_export(design, *tables) +
            "out vec4 value;\nvoid main() { value = vec4(nacre_brdf(vec3(0, 0, 1), vec3(0.6, 0, 0.8)), 1.0); "
            "}\n";
    }
    CHECK(validate(shaders) == "");
}

TEST_CASE("every preset's exported function fits into one shader with a prefix of its own") {
    std::string functions, sum;
    int index = 0;
    for (const Design& design : presets()) {
        const std::string prefix = fmt::format("material{}", index++);
        functions += glsl_export(design, *bake(design, {.quality = Quality::draft}), prefix);
        sum += fmt::format(" + {}_brdf(vec3(0, 0, 1), vec3(0.6, 0, 0.8))", prefix);
    }
    CHECK(functions.find("nacre_") == functions.npos);
    const std::string body = "out vec4 value;\nvoid main() { value = vec4(vec3(0)" + sum + ", 1.0); }\n";
    CHECK(validate({{"together.frag", "#version 330 core\n" + functions + body}}) == "");
}

TEST_CASE("the validator would notice") {
    CHECK(validate({{"bad.frag", "#version 330 core\nvoid main() { x = 1; }\n"}}) != "");
}

TEST_CASE("a variant's text is a function of its value, and leaves out what it does not need") {
    ShaderVariant plain;
    plain.lobes = {kind_index<Lobe, GgxLobe>()};
    const std::string text = fragment_shader(plain, "surface.frag");
    CHECK(text.find("ggx_density") != text.npos);
    for (const char* other : {"gaussian_density", "curve_lobe", "painted_lobe", "conductor_reflectance",
                              "correlated_projection", "coupled_share", "#define HAS_ALBEDO 1\n", "EACH_"})
        CHECK_MESSAGE(text.find(other) == text.npos, other);
    ShaderVariant lit = plain;
    lit.lights = 2;
    CHECK(fragment_shader(lit, "surface.frag") != fragment_shader(plain, "surface.frag"));
}

TEST_SUITE_END();
