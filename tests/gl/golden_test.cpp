// Every preset, scene and object against its reference picture.
#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <filesystem>

#include "app/headless/offscreen_context.h"
#include "app/preview/render.h"
#include "core/design/design_file.h"
#include "tests/gl/golden.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

constexpr glm::ivec2 size{160, 160};
// Rounding, the dither and another llvmpipe move a pixel by one or two; a moved highlight by tens.
constexpr GoldenRule rule{.worst = 6, .mean = 0.35};

void check_picture(const std::string& name, const RenderedImage& image) {
    check_golden(name, rule, image.size, image.rgb);
}

}  // namespace

TEST_SUITE_BEGIN("golden");

TEST_CASE("every preset looks as it did") {
    const auto context = make_offscreen_context({16, 16});
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(NACRE_SOURCE_DIR "/presets")) {
        if (entry.path().extension() != ".nacre") continue;
        check_picture(entry.path().stem().string(),
                      render_design(load_design(entry.path()), Scene{}, size, false));
        ++pictures;
    }
    CHECK(pictures >= 14);
}

TEST_CASE("every scene looks as it did") {
    const auto context = make_offscreen_context({16, 16});
    const Design design = load_design(NACRE_SOURCE_DIR "/presets/brushed-gold.nacre");
    for (const std::string& name : scene_names()) {
        if (name == "single") continue;
        check_picture("scene-" + name, render_design(design, *scene_by_name(name), size, false));
    }
}

TEST_CASE("every object looks as it did") {
    const auto context = make_offscreen_context({16, 16});
    const Design design = load_design(NACRE_SOURCE_DIR "/presets/satin.nacre");
    for (const std::string& name : object_names()) {
        if (name == "sphere") continue;
        Scene scene = *scene_by_name("two");
        scene.object = make_object(name);
        scene.rim_light = true;
        check_picture("object-" + name, render_design(design, scene, size, false));
    }
}

TEST_CASE("each side of a velvet cloth of two colours shows its own") {
    const auto context = make_offscreen_context({16, 16});
    Scene scene;
    scene.object = make_object("tablecloth");
    scene.light.theta = 8;
    const RenderedImage image =
        render_design(load_design(NACRE_SOURCE_DIR "/presets/shot-velvet.nacre"), scene, size, true);
    const auto mean = [&](glm::dvec2 low, glm::dvec2 high) {
        glm::dvec3 sum(0);
        int count = 0;
        for (int row = int(low.y * size.y); row < int(high.y * size.y); ++row)
            for (int column = int(low.x * size.x); column < int(high.x * size.x); ++column, ++count)
                for (int c = 0; c < 3; ++c)
                    sum[c] += static_cast<double>(
                        image.rgb[static_cast<std::size_t>((row * size.x + column) * 3 + c)]);
        return sum / static_cast<double>(count);
    };
    const glm::dvec3 left = mean({0.2, 0.45}, {0.3, 0.6}), right = mean({0.75, 0.45}, {0.83, 0.6});
    CHECK(left.x > 3 * left.z);
    CHECK(right.z > 3 * right.x);
}

TEST_CASE("the pictures show what their names promise") {
    const auto context = make_offscreen_context({16, 16});
    auto render = [](const char* name) {
        return render_design(
            load_design(fs::path(NACRE_SOURCE_DIR "/presets") / (std::string(name) + ".nacre")), Scene{},
            size, true);
    };
    auto at = [](const RenderedImage& image, double x, double y) {
        const int column = static_cast<int>((0.5 + 0.39 * x) * size.x),
                  row = static_cast<int>((0.5 - 0.39 * y) * size.y);
        return static_cast<double>(image.rgb[static_cast<std::size_t>((row * size.x + column) * 3)]);
    };
    // The highlight stands where the half vector is the normal.
    const glm::dvec3 h = glm::normalize(light_direction(Scene{}.light) + glm::dvec3{0, 0, 1});
    const RenderedImage gold = render("brushed-gold");
    // A streak along the meridian: far longer up and down than across.
    CHECK(at(gold, h.x, h.y - 0.4) > 3 * at(gold, h.x + 0.3, h.y));
    const RenderedImage velvet = render("velvet");
    // Toward the light's rim brighter than where plastic has its highlight.
    const double away = std::hypot(h.x, h.y);
    CHECK(at(velvet, 0.97 * h.x / away, 0.97 * h.y / away) > 1.3 * at(velvet, h.x, h.y));
    const RenderedImage satin = render("satin"), plastic = render("gold-painted-plastic");
    CHECK(at(satin, h.x, h.y - 0.35) > 1.2 * at(satin, h.x + 0.35, h.y - 0.1));
    CHECK(at(plastic, h.x, h.y) > 1.3 * at(plastic, h.x, h.y - 0.35));
    const RenderedImage ring = render("moon-ring");
    CHECK(at(ring, h.x, h.y - 0.43) > 3 * at(ring, h.x, h.y - 0.2));
}

TEST_SUITE_END();
