// The GLSL as a GPU runs it against core, the preview's and the exported one: every preset and every kind, on
// random pairs of directions.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/headless/offscreen_context.h"
#include "app/preview/gl_objects.h"
#include "app/preview/upload.h"
#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/formats/glsl_export.h"
#include "core/shading/shader_variant.h"
#include "shaders/shader_text.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// Rows and columns of pairs; fewer of an exported function that reads its numbers from a texture.
constexpr int side = 100, small_side = 40;

std::string text(const char* name) { return std::string(shader_text(name)); }

struct NamedDesign {
    std::string name;
    Design design;
};

std::vector<NamedDesign> designs() {
    std::vector<NamedDesign> all;
    for (const auto& entry : std::filesystem::directory_iterator(NACRE_SOURCE_DIR "/presets"))
        if (entry.path().extension() == ".nacre")
            all.push_back({entry.path().stem().string(), load_design(entry.path())});
    // What no preset uses: whole sphere, unclamped forms, Lambertian, no Fresnel, a tilted curve.
    Design sphere =
        with_layer(design_of(GgxLobe{0.4, 0.2}, 0, 0, 30), UniformLobe{UniformDomain::sphere}, 0.3);
    sphere.fresnel = NoFresnel{};
    sphere.diffuse = LambertianDiffuse{};
    sphere.shadowing.clamp = false;
    all.push_back({"sphere", sphere});
    Design curve = design_of(CurveLobe{}, 12, 50);
    curve.diffuse = CoupledDiffuse{};
    curve.shadowing = {SmithCorrelatedMasking{}, false};
    all.push_back({"tilted curve", curve});
    curve.specular.intensity = 3;
    all.push_back({"bright curve", curve});
    // Tints that differ, with and without clamp, and one that all layers share.
    Design velvet = with_layer(design_of(GaussianLobe{0.3, 0.6}, 40), GaussianLobe{0.3, 0.6}, 1, 40, 180);
    velvet.distribution.layers[0].tint = {0.7, 0.02, 0.08};
    velvet.distribution.layers[1].tint = {0.03, 0.04, 0.3};
    velvet.diffuse = CoupledDiffuse{};
    all.push_back({"velvet of two tints", velvet});
    velvet.fresnel = ConductorFresnel{};
    velvet.shadowing = {SmithCorrelatedMasking{}, false};
    velvet.diffuse = MetalDiffuse{};
    all.push_back({"metal of two tints", velvet});
    velvet.distribution.layers[1].tint = velvet.distribution.layers[0].tint;
    all.push_back({"metal of one tint", velvet});
    // Light that goes back, of p that half a turn changes and of one that it does not.
    Design dusty = with_layer(design_of(GgxLobe{0.2, 0.4}, 25, 40), GaussianLobe{0.3, 0.3}, 0.5, 20, 160);
    dusty.diffuse = CoupledDiffuse{};
    dusty.retro.weight = 0.4;
    all.push_back({"lopsided and retro-reflective", dusty});
    Design sign = design_of(GgxLobe{0.2, 0.4});
    sign.retro.weight = 1;
    all.push_back({"retro-reflective", sign});
    // Under a coat: leaning with every part, and a metal.
    dusty.multibounce = RankOneMultibounce{};
    dusty.coat = ClearCoat{0.2, 1.4, {0.9, 0.5, 0.2}};
    all.push_back({"lopsided, retro-reflective and coated", dusty});
    Design paint = design_of(GgxLobe{0.3, 0.3});
    paint.fresnel = ConductorFresnel{};
    paint.coat = ClearCoat{};
    all.push_back({"coated metal", paint});
    // Every kind there is.
    using Materials = KindSet<Fresnel>;
    for (std::size_t i = 0; i < std::max(KindSet<Lobe>::count, Materials::count); ++i) {
        Design design = design_of(lobe_of_widths(i % KindSet<Lobe>::count), 10, 20);
        design.fresnel = Materials::made(i % Materials::count);
        design.shadowing.model = KindSet<MaskingModel>::made(i % KindSet<MaskingModel>::count);
        design.diffuse = KindSet<Diffuse>::made(i % KindSet<Diffuse>::count);
        all.push_back({std::string(kind_name(design.distribution.layers[0].lobe)), design});
    }
    return all;
}

// Pairs whose half vector lies where p is, and pairs that lie anywhere.
std::vector<glm::vec4> random_pairs(const Tables& tables, int rows = side) {
    Random random(23);
    std::vector<glm::vec4> pairs;
    for (int i = 0; i < rows * rows; ++i) {
        const dvec3 k1 = random_direction(random);
        dvec3 k2 = random_direction(random);
        if (i % 2) {
            const dvec3 h = tables.distribution->sample_visible(k1, random);
            const dvec3 mirrored = glm::normalize(2 * glm::dot(k1, h) * h - k1);
            if (mirrored.z > 1e-4) k2 = mirrored;
        }
        pairs.emplace_back(k1, 0);
        pairs.emplace_back(k2, 0);
    }
    return pairs;
}

// `numbers` are the tables' as the program reads them.
std::vector<float> run(const Program& program, const Tables& tables, const std::vector<float>& numbers,
                       const std::vector<glm::vec4>& pairs, int rows = side) {
    Texture pair_texture, data;
    pair_texture.store({2 * rows, rows}, GL_RGBA32F, GL_RGBA, GL_FLOAT, pairs.data(), GL_NEAREST);
    store_data(data, numbers);
    Target target;
    target.bind({rows, rows}, GL_RGBA32F);
    glUseProgram(program.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, pair_texture.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, data.name());
    upload_surface(program, tables.shading, 0);
    set_uniform(program, "pairs", 1);
    FullScreen().draw();
    return target.read();
}

// At the edge of what is painted p rises from 0 within a texel, and float knows a place in a texel to some
// 1e-5: what is that small a part of a texel's value has few right digits. Of the presets only the smiley
// needs it: 1.3e-2 apart with 1e-6 of the largest value, 4.8e-3 with 1e-5, 5.8e-4 with 1e-4.
double least_value(const Shading<double>& shading) {
    for (int i = 0; i < shading.layer_count; ++i)
        if (lobe_reads_picture(shading.layers[i].kind) || shading.layers[i].picture_size > 0) return 1e-4;
    return 1e-6;
}

// The largest relative difference, of values above least_value() of the largest.
double worst_difference(const std::vector<float>& values, const Tables& tables,
                        const std::vector<glm::vec4>& pairs) {
    const Shading<double>& shading = tables.shading;
    std::vector<dvec3> expected;
    double largest = 0;
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
        const glm::dvec4 a(pairs[i]), b(pairs[i + 1]);
        expected.push_back(shading.brdf({a.x, a.y, a.z}, {b.x, b.y, b.z}));
        largest = std::max({largest, expected.back().x, expected.back().y, expected.back().z});
    }
    double worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double e = expected[i][static_cast<int>(c)];
            const double difference = std::fabs(static_cast<double>(values[4 * i + c]) - e);
            if (!(difference <= 1e9)) return 1e9;
            worst = std::max(worst, difference / std::max(e, least_value(shading) * largest));
        }
    return worst;
}

// parity.frag with an exported function in the place of the shared mathematics.
std::string fragment_of(const std::string& exported) {
    std::string main = text("parity.frag");
    main.replace(main.find("vec4(brdf("), 10, "vec4(nacre_brdf(");
    return "#version 330 core\n" + exported + main;
}

struct TextAndNumbers {
    std::string text;
    std::vector<float> numbers;
};

// An exported text whose fetch reads a texture in place of the array, and the array's numbers, as
// docs/glsl.md advises for large tables.
TextAndNumbers part_numbers(std::string exported) {
    const std::string look_up = "nacre_data[index]", array = "const float nacre_data[";
    exported.replace(exported.find(look_up), look_up.size(),
                     "texelFetch(surface_data, ivec2(index & 1023, index >> 10), 0).r");
    const std::size_t begin = exported.find(array), end = exported.find(");", begin);
    std::size_t at = exported.find("(", begin) + 1;
    TextAndNumbers parted;
    while (at < end) {
        const std::size_t next = std::min(exported.find(',', at), end);
        parted.numbers.push_back(std::strtof(exported.c_str() + at, nullptr));
        at = next + 1;
    }
    parted.text = exported.replace(begin, end + 2 - begin, "uniform sampler2D surface_data;");
    return parted;
}

}  // namespace

TEST_SUITE_BEGIN("parity");

TEST_CASE("GLSL pixels agree with core within 2e-3") {
    const auto context = make_offscreen_context({16, 16});
    for (const NamedDesign& d : designs()) {
        CAPTURE(d.name);
        for (const bool albedo : {false, true}) {
            const auto tables = bake(d.design, {.quality = Quality::draft, .albedo = albedo});
            const Program program(text("full_screen.vert"),
                                  fragment_shader(variant_of(tables->shading), "parity.frag"));
            const auto pairs = random_pairs(*tables);
            CHECK(worst_difference(run(program, *tables, tables->data, pairs), *tables, pairs) < 2e-3);
        }
    }
}

TEST_CASE("the exported GLSL function agrees with core within 2e-3, its numbers as they stand in the text") {
    const auto context = make_offscreen_context({16, 16});
    int compared = 0;
    for (const NamedDesign& d : designs()) {
        CAPTURE(d.name);
        const auto tables = bake(d.design, {.quality = Quality::draft});
        // llvmpipe copies a constant array for every look-up: only small ones can be run as they are.
        if (tables->data.size() > 150) continue;
        ++compared;
        const Program program(text("full_screen.vert"), fragment_of(glsl_export(d.design, *tables)));
        const auto pairs = random_pairs(*tables);
        CHECK(worst_difference(run(program, *tables, {0}, pairs), *tables, pairs) < 2e-3);
    }
    CHECK(compared >= 3);
}

TEST_CASE("every exported GLSL function agrees with core within 2e-3, its numbers put into a texture") {
    const auto context = make_offscreen_context({16, 16});
    std::size_t largest = 0;
    for (const NamedDesign& d : designs()) {
        CAPTURE(d.name);
        const auto tables = bake(d.design, {.quality = Quality::draft});
        const TextAndNumbers parted = part_numbers(glsl_export(d.design, *tables));
        REQUIRE(parted.numbers == tables->data);
        largest = std::max(largest, parted.numbers.size());
        const Program program(text("full_screen.vert"), fragment_of(parted.text));
        const auto pairs = random_pairs(*tables, small_side);
        CHECK(worst_difference(run(program, *tables, parted.numbers, pairs, small_side), *tables, pairs) <
              2e-3);
    }
    CHECK(largest > 10000);
}

TEST_SUITE_END();
