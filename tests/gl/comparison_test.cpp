// Two surfaces side by side, and one factor of the BRDF alone, as the preview draws them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/headless/offscreen_context.h"
#include "app/preview/preview.h"
#include "app/preview/render.h"
#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/design/design_file.h"

using namespace nacre;

namespace {

constexpr glm::ivec2 size{96, 96};

Design preset(const char* name) {
    return load_design(std::string(NACRE_SOURCE_DIR "/presets/") + name + ".nacre");
}

ComparedSurface surface(const Design& design, const std::optional<ComparisonModel>& comparison_model = {},
                        bool albedo = false) {
    Baker baker;
    return bake_for_comparison(baker, design, comparison_model,
                               {.quality = Quality::draft, .albedo = albedo});
}

double at(const std::vector<float>& picture, glm::ivec2 pixel, int channels, int channel) {
    return static_cast<double>(
        picture[static_cast<std::size_t>((pixel.y * size.x + pixel.x) * channels + channel)]);
}

}  // namespace

TEST_SUITE_BEGIN("comparison");

TEST_CASE("left of the divider stands the left picture, right of it the right one, to the bit") {
    const auto context = make_offscreen_context({16, 16});
    const Design satin = preset("satin");
    const RenderedPair pair =
        render_pair(surface(satin), surface(satin, ClosedFormModel::ward), {}, size, false);
    CHECK(pair.left.rgb == render_pair(surface(satin), surface(satin), {}, size, false).right.rgb);
    CHECK(pair.left.rgb != pair.right.rgb);
    const double divider = 0.4;
    const std::vector<float> both = divided_picture(pair.left.rgb, pair.right.rgb, size, 3, divider);
    const int column = divider_column(size.x, divider);
    CHECK(column == 38);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            for (int c = 0; c < 3; ++c)
                REQUIRE(at(both, {x, y}, 3, c) ==
                        at(x < column ? pair.left.rgb : pair.right.rgb, {x, y}, 3, c));
}

TEST_CASE("a design differs from itself by nothing, and from others by a number") {
    const auto context = make_offscreen_context({16, 16});
    const Design velvet = preset("velvet");
    const RenderedPair same = render_pair(surface(velvet), surface(velvet), {}, size, false);
    CHECK(same.difference.pixels > 3000);
    CHECK(same.difference.root_mean_square == 0);
    CHECK(same.difference.largest == 0);
    CHECK(same.difference.relative == 0);
    const std::vector<float> black = difference_picture(same.left_radiance, same.right_radiance, 3, {});
    CHECK(*std::max_element(black.begin(), black.end()) == 0);
    const RenderedPair other =
        render_pair(surface(velvet), surface(velvet, MaskingModel(UncorrelatedMasking{})), {}, size, false);
    CHECK(other.difference.largest > other.difference.root_mean_square);
    CHECK(other.difference.root_mean_square > 1e-4);
    // Only what the masking changes: velvet's retroreflection is the correlated one's, so left is brighter.
    const std::vector<float> orange_or_blue = difference_picture(other.left_radiance, other.right_radiance, 3,
                                                                 {.amplification = 50, .is_signed = true});
    double red = 0, blue = 0;
    for (std::size_t i = 0; i < orange_or_blue.size(); i += 3) {
        red += static_cast<double>(orange_or_blue[i]);
        blue += static_cast<double>(orange_or_blue[i + 2]);
    }
    CHECK(blue > 2 * red);
}

TEST_CASE("the factors' pictures multiply to the specular picture, which with the diffuse one is the whole") {
    const auto context = make_offscreen_context({16, 16});
    Design design = preset("gold-painted-plastic");
    const auto tables = bake(design, {.quality = Quality::draft});
    Preview preview;
    preview.set(tables);
    Scene scene;
    const auto draw = [&](Term term) {
        scene.term = term;
        return preview.picture(scene, size, 1, true);
    };
    const auto p = draw(Term::density), f = draw(Term::fresnel), gg = draw(Term::inverse_areas),
               p1 = draw(Term::masking1), p2 = draw(Term::masking2), specular = draw(Term::specular),
               diffuse = draw(Term::diffuse), total = draw(Term::total);
    const SurfaceImage& object = preview.surface(scene, size);
    const double N = tables->shading.surface.N;
    int lit = 0;
    for (int y = 2; y < size.y - 2; ++y)
        for (int x = 2; x < size.x - 2; ++x) {
            const auto point = object.at({x + 0.5, y + 0.5});
            const glm::ivec2 texel{x, size.y - 1 - y};
            if (!point) continue;
            const double c1 = glm::dot(point->frame[2], light_direction(scene.light)), c2 = point->frame[2].z;
            if (c1 < 0.02 || c2 < 0.2) continue;
            ++lit;
            for (int c = 0; c < 3; ++c) {
                const double product = at(p, texel, 4, 0) * at(f, texel, 4, c) * at(gg, texel, 4, 0) * N / 4 *
                                       scene.light.irradiance[c] * c1;
                CHECK(at(specular, texel, 4, c) == doctest::Approx(product).epsilon(2e-4));
                CHECK(at(total, texel, 4, c) ==
                      doctest::Approx(at(specular, texel, 4, c) + at(diffuse, texel, 4, c)).epsilon(1e-4));
            }
            CHECK(at(p1, texel, 4, 0) * at(p2, texel, 4, 0) ==
                  doctest::Approx(at(gg, texel, 4, 0) * N * N * c1 * c2).epsilon(2e-4));
        }
    CHECK(lit > 1500);
}

TEST_CASE("a model's picture is its formula, and its share of ambient light is its albedo") {
    const auto context = make_offscreen_context({16, 16});
    const Design design = preset("brushed-gold");
    for (const ClosedFormInfo& model : all_closed_forms()) {
        CAPTURE(model.name);
        const ComparedSurface shown = surface(design, model.model, true);
        Preview preview;
        preview.set(shown.tables, shown.model);
        Scene scene;
        const auto lit = preview.picture(scene, size, 1, true);
        const SurfaceImage& object = preview.surface(scene, size);
        double worst = 0;
        for (int y = 8; y < size.y - 8; y += 3)
            for (int x = 8; x < size.x - 8; x += 3) {
                const auto point = object.at({x + 0.5, y + 0.5});
                if (!point) continue;
                const dvec3 k1 = light_direction(scene.light) * point->frame;
                const dvec3 k2 = dvec3{0, 0, 1} * point->frame;
                if (k1.z < 0.05 || k2.z < 0.3) continue;
                const dvec3 wanted = closed_form_brdf(shown.tables->shading, shown.model->form, k1, k2) *
                                     scene.light.irradiance * k1.z;
                const double drawn = at(lit, {x, size.y - 1 - y}, 4, 0);
                worst = std::fmax(worst, std::fabs(drawn - wanted.x) / (std::fabs(wanted.x) + 0.01));
            }
        CHECK(worst < 2e-3);
        // In the dark but for radiance 1 from everywhere, a pixel is the model's albedo.
        scene.light.irradiance = glm::dvec3{0};
        scene.ambient = true;
        scene.ambient_radiance = glm::dvec3{1};
        scene.term = model.model == ClosedFormModel::oren_nayar ? Term::diffuse : Term::specular;
        const auto ambient = preview.picture(scene, size, 1, true);
        const double middle = at(ambient, size / 2, 4, 0);
        CHECK(middle == doctest::Approx(static_cast<double>(shown.model->albedo[0])).epsilon(0.02));
    }
}

TEST_SUITE_END();
