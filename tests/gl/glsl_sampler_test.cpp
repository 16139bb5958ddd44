// The exported function whose tables are a texture, as a GPU runs it, against core: one by itself, two in one
// shader, and how long it takes to compile.
#include "core/formats/glsl_sampler.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "app/headless/offscreen_context.h"
#include "app/preview/gl_objects.h"
#include "app/preview/upload.h"
#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"
#include "core/model/lobes.h"
#include "shaders/shader_text.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr int side = 40;  // rows and columns of pairs

std::string text(const char* name) { return std::string(shader_text(name)); }

std::shared_ptr<const Tables> preset(const std::string& name, Design& design) {
    design = load_design(NACRE_SOURCE_DIR "/presets/" + name + ".nacre");
    return bake(design, {.quality = Quality::draft});
}

// Half of the pairs mirror each other about a facet.
std::vector<glm::vec4> pairs_of(const Tables& tables) {
    Random random(29);
    std::vector<glm::vec4> pairs;
    for (int i = 0; i < side * side; ++i) {
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

// parity.frag with a call of exported functions in the place of the shared mathematics.
std::string fragment_of(const std::string& exported, const std::string& call) {
    std::string main = text("parity.frag");
    const std::string brdf = "brdf(k1, k2)";
    main.replace(main.find(brdf), brdf.size(), call);
    return "#version 330 core\n" + exported + main;
}

// The bytes of the .f32 file as a program would load them.
void store_bytes(Texture& texture, const Tables& tables) {
    const std::string bytes = texture_bytes(sampler_data(tables));
    REQUIRE(bytes.size() % 4096 == 0);
    const int rows = static_cast<int>(bytes.size() / 4096);
    texture.store({1024, rows}, GL_R32F, GL_RED, GL_FLOAT, bytes.data(), GL_NEAREST);
}

struct BoundTables {
    const char* name;  // of the sampler
    const Tables* tables;
};

std::vector<float> run(const Program& program, const std::vector<BoundTables>& bound,
                       const std::vector<glm::vec4>& pairs) {
    Texture pair_texture;
    pair_texture.store({2 * side, side}, GL_RGBA32F, GL_RGBA, GL_FLOAT, pairs.data(), GL_NEAREST);
    std::vector<Texture> textures(bound.size());
    for (std::size_t i = 0; i < bound.size(); ++i) store_bytes(textures[i], *bound[i].tables);
    Target target;
    target.bind({side, side}, GL_RGBA32F);
    glUseProgram(program.name());
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const int unit = static_cast<int>(i) + 1;
        textures[i].bind(unit);
        set_uniform(program, bound[i].name, unit);
    }
    pair_texture.bind(0);
    set_uniform(program, "pairs", 0);
    FullScreen().draw();
    return target.read();
}

// At the edge of what is painted float knows few digits of p; see parity_test.cpp.
double least_value(const Shading<double>& shading) {
    for (int i = 0; i < shading.layer_count; ++i)
        if (lobe_reads_picture(shading.layers[i].kind) || shading.layers[i].picture_size > 0) return 1e-4;
    return 1e-6;
}

// The largest relative difference, of values above least_value() of the largest; the BRDF is that of
// `weights`.
double worst_difference(const std::vector<float>& values, const std::vector<BoundTables>& bound,
                        const std::vector<glm::vec4>& pairs) {
    std::vector<dvec3> expected;
    double largest = 0, least = 0;
    for (const BoundTables& each : bound) least = std::max(least, least_value(each.tables->shading));
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
        const glm::dvec4 a(pairs[i]), b(pairs[i + 1]);
        dvec3 sum(0);
        for (const BoundTables& each : bound)
            sum += each.tables->shading.brdf({a.x, a.y, a.z}, {b.x, b.y, b.z});
        expected.push_back(sum);
        largest = std::max({largest, sum.x, sum.y, sum.z});
    }
    REQUIRE(largest > 0);
    double worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double e = expected[i][static_cast<int>(c)];
            const double difference = std::fabs(static_cast<double>(values[4 * i + c]) - e);
            if (!(difference <= 1e9)) return 1e9;
            worst = std::max(worst, difference / std::max(e, least * largest));
        }
    return worst;
}

}  // namespace

TEST_SUITE_BEGIN("glsl with a sampler");

TEST_CASE("every preset's function agrees with core within 2e-3") {
    const auto context = make_offscreen_context({16, 16});
    std::size_t largest = 0;
    for (const auto& entry : std::filesystem::directory_iterator(NACRE_SOURCE_DIR "/presets")) {
        if (entry.path().extension() != ".nacre") continue;
        Design design;
        const auto tables = preset(entry.path().stem().string(), design);
        CAPTURE(design.name);
        const Program program(text("full_screen.vert"),
                              fragment_of(glsl_sampler_text(design, *tables, "nacre"), "nacre_brdf(k1, k2)"));
        const std::vector<BoundTables> bound{{"nacre_data", tables.get()}};
        const auto pairs = pairs_of(*tables);
        CHECK(worst_difference(run(program, bound, pairs), bound, pairs) < 2e-3);
        largest = std::max(largest, tables->data.size());
    }
    CHECK(largest > 10000);
}

TEST_CASE("two materials in one shader are right") {
    const auto context = make_offscreen_context({16, 16});
    Design first, second;
    const auto gold = preset("brushed-gold", first), satin = preset("satin", second);
    const Program program(
        text("full_screen.vert"),
        fragment_of(glsl_sampler_text(first, *gold, "gold") + glsl_sampler_text(second, *satin, "satin"),
                    "gold_brdf(k1, k2) + satin_brdf(k1, k2)"));
    const std::vector<BoundTables> bound{{"gold_data", gold.get()}, {"satin_data", satin.get()}};
    const auto pairs = pairs_of(*gold);
    const auto values = run(program, bound, pairs);
    CHECK(worst_difference(values, bound, pairs) < 2e-3);
    // Neither of them alone would do.
    for (const BoundTables& each : bound) CHECK(worst_difference(values, {each}, pairs) > 0.1);
}

TEST_CASE("what the exported function samples has the density that it says") {
    const auto context = make_offscreen_context({16, 16});
    for (const std::string name : {"satin", "brushed-gold", "smiley", "scarlet-car-paint"}) {
        CAPTURE(name);
        Design design;
        const auto tables = preset(name, design);
        const auto pairs = pairs_of(*tables);
        // k1 serves as three numbers in [0, 1).
        const std::string drawn = "nacre_sample(k2, fract(7.0 * k1))";
        const Program program(text("full_screen.vert"),
                              fragment_of(glsl_sampler_text(design, *tables, "nacre"),
                                          "vec3(" + drawn + ".w, nacre_pdf(" + drawn + ".xyz, k2), length(" +
                                              drawn + ".xyz))"));
        const auto values = run(program, {{"nacre_data", tables.get()}}, pairs);
        int kept = 0;
        for (std::size_t i = 0; i + 3 < values.size(); i += 4) {
            if (!(values[i] > 0)) continue;
            ++kept;
            CHECK(values[i + 1] == doctest::Approx(values[i]).epsilon(1e-3));
            CHECK(values[i + 2] == doctest::Approx(1).epsilon(1e-3));
        }
        CHECK(kept > static_cast<int>(values.size() / 16));
    }
}

TEST_CASE("the bytes are the tables in order, and zeros to the end of a row") {
    Design design;
    const auto tables = preset("satin", design);
    const std::vector<float> data = sampler_data(*tables);
    CHECK(data.size() > tables->data.size());
    const std::string bytes = texture_bytes(data);
    CHECK(bytes.size() == static_cast<std::size_t>(texture_rows(data.size())) * 4096);
    CHECK(bytes.size() - data.size() * 4 < 4096);
    std::vector<float> read(bytes.size() / 4);
    std::memcpy(read.data(), bytes.data(), bytes.size());
    for (std::size_t i = 0; i < read.size(); ++i) CHECK(read[i] == (i < data.size() ? data[i] : 0.0f));
    CHECK(std::equal(tables->data.begin(), tables->data.end(), data.begin()));
}

TEST_SUITE_END();
