// The shaders of exported texts as GLSL ES 3.00, which WebGL 2 compiles: glslangValidator accepts them of
// every preset and kind.
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/bake/bake.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_sampler.h"
#include "core/formats/web_shader.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

// What the validator says of all of them; empty when all is well.
std::string validate(const std::map<std::string, std::string>& shaders) {
    const fs::path folder = fs::temp_directory_path() / fmt::format("nacre-web-shaders-{}", getpid());
    fs::create_directories(folder);
    std::string files;
    for (const auto& [name, text] : shaders) {
        std::ofstream(folder / name) << text;
        files += " '" + (folder / name).string() + "'";
    }
    FILE* pipe = popen(("glslangValidator" + files + " 2>&1").c_str(), "r");
    REQUIRE(pipe);
    std::string output;
    char buffer[4096];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, n);
    const int status = pclose(pipe);
    fs::remove_all(folder);
    return status == 0 ? "" : output + fmt::format("exit {}", status);
}

std::vector<Design> designs() {
    std::vector<Design> all;
    for (const auto& entry : fs::directory_iterator(NACRE_SOURCE_DIR "/presets"))
        if (entry.path().extension() == ".nacre") all.push_back(load_design(entry.path()));
    for (std::size_t i = 0; i < KindSet<Fresnel>::count; ++i) {
        Design design;
        design.distribution.layers[0].lobe = lobe_of_widths(i % KindSet<Lobe>::count);
        design.fresnel = KindSet<Fresnel>::made(i);
        design.shadowing.model = KindSet<MaskingModel>::made(i % KindSet<MaskingModel>::count);
        design.diffuse = KindSet<Diffuse>::made(i % KindSet<Diffuse>::count);
        if (i % 2) design.retro.weight = 0.5;
        if (i % 3 == 0) design.coat = ClearCoat{};
        all.push_back(design);
    }
    return all;
}

// With the lines that the page puts in.
std::string with_lights(std::string text, int lights, bool ambient) {
    text = with_text(text, "#define LIGHTS 1", fmt::format("#define LIGHTS {}", lights));
    return with_text(text, "#define AMBIENT_LIGHT 0",
                     fmt::format("#define AMBIENT_LIGHT {}", ambient ? 1 : 0));
}

}  // namespace

TEST_SUITE_BEGIN("web page");

TEST_CASE("glslangValidator accepts every design's web page and its function with a sampler as GLSL ES") {
    std::map<std::string, std::string> shaders{{"page.vert", web_vertex_shader()}};
    int index = 0;
    for (const Design& design : designs()) {
        const auto tables = bake(design, {.quality = Quality::draft, .albedo = true});
        const std::string page = web_fragment_shader(tables->shading, "page.frag");
        shaders[fmt::format("page-{}.frag", index)] = page;
        shaders[fmt::format("dark-{}.frag", index)] = with_lights(page, 0, false);
        shaders[fmt::format("ambient-{}.frag", index)] = with_lights(page, 2, true);
        shaders[fmt::format("light-{}.frag", index)] = web_fragment_shader(tables->shading, "light.frag");
        shaders[fmt::format("export-{}.frag", index++)] =
            "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n" +
            glsl_sampler_text(design, *tables, "two") + glsl_sampler_text(design, *tables, "names") +
            "out vec4 value;\nvoid main() { value = vec4(two_brdf(vec3(0, 0, 1), vec3(0.6, 0, 0.8)) + "
            "names_brdf(vec3(0, 0, 1), vec3(0.6, 0, 0.8)), 1.0); }\n";
    }
    CHECK(validate(shaders) == "");
}

TEST_SUITE_END();
