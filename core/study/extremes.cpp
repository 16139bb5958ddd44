#include "core/study/extremes.h"

#include <fmt/core.h>

#include <cmath>

#include "core/study/bounce_extremes.h"
#include "core/study/coat_extremes.h"
#include "core/study/kind_extremes.h"
#include "core/study/retro_extremes.h"

namespace nacre {
namespace {

using Cases = std::vector<ExtremeCase>;

constexpr double infinity = limits::infinity;
constexpr double usual_claim = ExtremeClaims{}.area;
constexpr const char* no_facets = "the layer holds no facets";
constexpr const char* faces_down = "the facets must face up on the whole";

Design with_layer(Design design, Lobe lobe, double weight, double tilt = 0, double azimuth = 0) {
    Layer layer;
    layer.lobe = std::move(lobe);
    layer.weight = weight;
    layer.tilt = tilt;
    layer.azimuth = azimuth;
    design.distribution.layers.push_back(std::move(layer));
    return design;
}

Design of(Lobe lobe, double tilt = 0, double azimuth = 0) {
    Design design;
    design.distribution.layers.clear();
    return with_layer(std::move(design), std::move(lobe), 1, tilt, azimuth);
}

Diffuse white_diffuse(std::size_t kind) {
    return KindSet<Diffuse>::made_by(kind, []<class T>() { return T::of_albedo(glm::dvec3{1}); });
}

Design grooves(double width, double tilt) {
    return with_layer(of(GaussianLobe{width, width}, tilt), GaussianLobe{width, width}, 1, tilt, 180);
}

Picture one_texel(int side, int at_column, int at_row) {
    return picture_of_texels(
        side, [=](int column, int row) { return column == at_column && row == at_row ? 1 : 0; });
}

Picture blob(double brightness) {
    return picture_of_texels(16, [=](int column, int row) {
        return brightness * std::exp(-0.05 * ((column - 9) * (column - 9) + (row - 6) * (row - 6)));
    });
}

Design modulated(Lobe lobe, Picture image, double strength) {
    Design design = of(std::move(lobe));
    design.distribution.layers.front().modulation = Modulation{std::move(image), strength};
    return design;
}

ExtremeCase lobe_alone(const char* group, std::string name, const Lobe& lobe) {
    const ExtremeClaims claims = extreme_claims(lobe);
    return {group, std::move(name), of(lobe), claims.refusal, {}, claims.area, claims.albedo};
}

void add_lobes(Cases& cases) {
    for (const auto& [name, lobe] : extreme_kinds<Lobe>()) cases.push_back(lobe_alone("lobes", name, lobe));
}

// Of every lobe that has two widths, the second also infinite where it may be.
void add_ratios(Cases& cases) {
    auto add = [&](glm::dvec2 widths) {
        for (std::size_t kind = 0; kind < KindSet<Lobe>::count; ++kind) {
            const Lobe lobe = lobe_of_widths(kind, widths);
            if (widths_of(lobe) != widths) continue;
            const std::string across = std::isinf(widths.y) ? "infinity" : fmt::format("{:g}", widths.y);
            cases.push_back(
                lobe_alone("ratios", fmt::format("{} ({:g}, {})", kind_name(lobe), widths.x, across), lobe));
        }
    };
    for (const glm::dvec2 widths : {glm::dvec2{1e-4, 1e2}, {1e-3, 1e3}, {1e-2, 1e4}, {0.1, 1}}) add(widths);
    for (const double width : {1e-4, 1.0, 1e4}) add({width, infinity});
    Design turned = of(GgxLobe{1e-3, 1e3});
    turned.distribution.layers.front().rotation = 33;
    cases.push_back({"ratios", "ggx (0.001, 1000) turned by 33 degrees", turned});
}

void add_tilts(Cases& cases) {
    auto add = [&](std::string name, Design design, double area_claim) {
        cases.push_back({"tilts", std::move(name), std::move(design)});
        cases.back().area_claim = area_claim;
    };
    for (const double width : {1e-3, 0.1, 1.0})
        add(fmt::format("gaussian {:g} by 89 degrees", width), of(GaussianLobe{width, width}, 89),
            tilted_area_claim);
    add("ggx 0.0001 by 45 degrees", of(GgxLobe{1e-4, 1e-4}, 45), usual_claim);
    cases.back().albedo_claim = layer_albedo_claim;
    add("inverse gaussian 0.01 by 89 degrees", of(InverseGaussianLobe{0.01}, 89), usual_claim);
    add("gaussian (0.01, infinity) by 89 degrees", of(GaussianLobe{0.01, infinity}, 89), usual_claim);
    add("gaussian (infinity, 0.01) by 89 degrees", of(GaussianLobe{infinity, 0.01}, 89), tilted_area_claim);
    add("grooves of 0.001", grooves(1e-3, 20), tilted_area_claim);
    add("grooves of 0.01", grooves(0.01, 20), usual_claim);
    add("grooves of 0.1", grooves(0.1, 20), usual_claim);
    add("grooves of 0.01 by 80 degrees", grooves(0.01, 80), usual_claim);
    // The paper's (sec. 6.4), N doubled by hand.
    Design slanted = of(GaussianLobe{0.5, infinity}, 40);
    slanted.distribution.mean_cosine_scale = 2;
    slanted.shadowing.model = CorrelatedMasking{};
    add("slanted velvet", slanted, usual_claim);
    slanted.shadowing.clamp = false;
    add("slanted velvet, no clamp", slanted, tilted_area_claim);
    cases.back().albedo_claim = layer_albedo_claim;
}

void add_mixtures(Cases& cases) {
    for (const double weight : {1e-6, 1e-3, 1.0})
        cases.push_back({"mixtures", fmt::format("needle 0.0001 of weight {:g} over a haze", weight),
                         with_layer(of(UniformLobe{}), GaussianLobe{1e-4, 1e-4}, weight)});
    cases.push_back({"mixtures", "haze of weight 1e-06 over a leaning needle",
                     with_layer(of(GaussianLobe{1e-3, 1e-3}, 30), UniformLobe{}, 1e-6)});
    cases.back().area_claim = tilted_area_claim;
    cases.back().albedo_claim = layer_albedo_claim;
    Design many = of(GaussianLobe{1e-4, 1e-4});
    for (int i = 1; i < limits::layers_max; ++i) {
        const double width = 1e-4 * std::pow(10, 0.5 * i);
        many = with_layer(std::move(many), GgxLobe{width, width}, std::pow(10, -0.2 * i));
    }
    cases.push_back({"mixtures", "as many layers as there may be", many});
}

void add_pictures(Cases& cases) {
    auto painted = [](Picture image) { return of(PaintedLobe{std::move(image)}); };
    auto add_texel = [&](const char* name, int side, int column, int row) {
        cases.push_back({"pictures", name, painted(one_texel(side, column, row))});
        cases.back().albedo_claim = layer_albedo_claim;
    };
    add_texel("one texel of 64 x 64, upright", 64, 32, 32);
    add_texel("one texel of 256 x 256, leaning", 256, 170, 90);
    add_texel("one texel of 64 x 64, at the horizon", 64, 0, 32);
    cases.push_back({"pictures", "one texel outside the disk", painted(one_texel(64, 0, 0)), no_facets});
    cases.push_back(
        {"pictures", "black", painted(picture_of_texels(32, [](int, int) { return 0; })), no_facets});
    cases.push_back({"pictures", "modulation by black",
                     modulated(GaussianLobe{}, picture_of_texels(8, [](int, int) { return 0; }), 1),
                     no_facets});
    cases.push_back({"pictures", "needle 0.0001 modulated by a checkerboard",
                     modulated(GaussianLobe{1e-4, 1e-4}, checkerboard(64), 1)});
}

// rho does not know the unit of p: each is to be the same as without the factor.
void add_scales(Cases& cases) {
    const Design mixture = with_layer(of(GaussianLobe{0.1, 0.1}), GgxLobe{0.4, 0.4}, 0.5);
    for (const double factor : {1e-30, 1e30 / 2}) {
        Design scaled = mixture;
        for (Layer& layer : scaled.distribution.layers) layer.weight *= factor;
        cases.push_back({"scales", fmt::format("weights times {:g}", factor), scaled, {}, mixture});
    }
    const CurveLobe curve{{{0, 1}, {15, 0.2}, {50, 0.7}, {80, 0}}};
    for (const double factor : {1e-300, 1e-30, 1e30}) {
        CurveLobe scaled = curve;
        for (auto& point : scaled.points) point.second *= factor;
        cases.push_back({"scales", fmt::format("curve times {:g}", factor), of(scaled), {}, of(curve)});
    }
    // Powers of two, which keep a texel's digits.
    for (const int power : {-100, 127}) {
        const double factor = std::ldexp(1, power);
        cases.push_back({"scales",
                         fmt::format("picture times 2^{}", power),
                         of(PaintedLobe{blob(factor)}),
                         {},
                         of(PaintedLobe{blob(1)})});
        cases.push_back({"scales",
                         fmt::format("modulation times 2^{}", power),
                         modulated(GaussianLobe{0.3, 0.3}, blob(factor), 1),
                         {},
                         modulated(GaussianLobe{0.3, 0.3}, blob(1), 1)});
    }
}

void add_mean_cosines(Cases& cases) {
    const Design sphere = of(UniformLobe{UniformDomain::sphere});
    cases.push_back(
        {"mean cosine", "N = 1e-08", with_layer(sphere, GaussianLobe{1e-3, 1e-3}, 1e-8), faces_down});
    for (const double weight : {1e-6, 1e-2})
        cases.push_back({"mean cosine", fmt::format("whole sphere, N = {:g}", weight),
                         with_layer(sphere, GaussianLobe{1e-3, 1e-3}, weight)});
    cases.push_back({"mean cosine", "facing down", of(GaussianLobe{}, 180), faces_down});
    cases.push_back({"mean cosine", "on edge", of(GaussianLobe{0.01, 0.01}, 90), faces_down});
    cases.push_back({"mean cosine", "by 89.99 degrees", of(GgxLobe{0.01, 0.01}, 89.99)});
    Design empty = of(GaussianLobe{});
    empty.distribution.layers.front().weight = 0;
    cases.push_back({"mean cosine", "weight 0", empty, "no enabled layer has a weight above 0"});
    for (const double scale : {limits::mean_cosine_scale_min, limits::mean_cosine_scale_max}) {
        Design scaled = of(GaussianLobe{0.3, 0.3});
        scaled.distribution.mean_cosine_scale = scale;
        cases.push_back({"mean cosine", fmt::format("N times {:g}", scale), scaled});
    }
}

// Each model as it comes and at its extremes, on a tilted p; t of less than a degree on an upright one, since
// the reference takes a minute for one R of a tilted p.
void add_visibilities(Cases& cases) {
    std::vector<NamedValue<MaskingModel>> models;
    for (std::size_t kind = 0; kind < KindSet<MaskingModel>::count; ++kind)
        models.push_back(
            {std::string(KindSet<MaskingModel>::names[kind]), KindSet<MaskingModel>::made(kind)});
    for (const auto& extreme : extreme_kinds<MaskingModel>())
        if (extreme.value != KindSet<MaskingModel>::made(extreme.value.index())) models.push_back(extreme);
    for (const auto& [name, model] : models)
        for (const bool clamp : {true, false}) {
            const bool narrow = masking_bends(model.index()) == MaskingBends::azimuth &&
                                std::visit([](const auto& kind) { return kind.shader_width(); }, model) < 1;
            Design design = of(GaussianLobe{0.3, 0.3}, narrow ? 0 : 50);
            design.shadowing = {model, clamp};
            design.diffuse = CoupledDiffuse{};
            cases.push_back({"visibility", fmt::format("{}{}", name, clamp ? "" : ", no clamp"), design});
            if (narrow) continue;
            const ExtremeClaims claims = tilted_claims(model, clamp);
            cases.back().area_claim = claims.area;
            cases.back().albedo_claim = claims.albedo;
        }
}

// Each extreme reflectance under each diffuse kind in white, then each extreme of the diffuse kinds.
void add_materials(Cases& cases) {
    auto add = [&](std::string name, const Fresnel& fresnel, const Diffuse& diffuse) {
        Design design = of(GgxLobe{0.3, 0.3});
        design.fresnel = fresnel;
        design.diffuse = diffuse;
        cases.push_back({"materials", std::move(name), design});
        cases.back().albedo_claim = extreme_claims(fresnel).albedo;
    };
    const std::vector<NamedValue<Fresnel>> reflectances = extreme_kinds<Fresnel>();
    for (const auto& [name, fresnel] : reflectances)
        for (std::size_t kind = 0; kind < KindSet<Diffuse>::count; ++kind)
            add(fmt::format("fresnel {}, diffuse {}", name, KindSet<Diffuse>::names[kind]), fresnel,
                white_diffuse(kind));
    for (const auto& [name, diffuse] : extreme_kinds<Diffuse>())
        if (diffuse != white_diffuse(diffuse.index())) add("diffuse " + name, Fresnel{}, diffuse);
}

// With the coupled term in white, which takes what the specular term of intensity 1 leaves.
void add_intensities(Cases& cases) {
    for (const double intensity : {0.0, 1.0, limits::intensity_max}) {
        Design design = of(GgxLobe{0.3, 0.3}, 30);
        design.diffuse = CoupledDiffuse{glm::dvec3{1}};
        design.specular.intensity = intensity;
        cases.push_back({"intensity", fmt::format("specular intensity {:g}", intensity), design});
    }
}

// Grooves whose sides differ as much as they can, with each diffuse term in white; and facets that reflect
// nothing.
void add_tints(Cases& cases) {
    const auto add = [&](std::string name, Design design, glm::dvec3 one, glm::dvec3 other) {
        design.distribution.layers[0].tint = one;
        design.distribution.layers[1].tint = other;
        cases.push_back({"tints", std::move(name), std::move(design)});
    };
    for (std::size_t kind = 0; kind < KindSet<Diffuse>::count; ++kind) {
        Design design = grooves(0.5, 40);
        design.fresnel = ConductorFresnel{};
        design.diffuse = white_diffuse(kind);
        add(fmt::format("red and cyan, diffuse {}", KindSet<Diffuse>::names[kind]), design, {1, 0, 0},
            {0, 1, 1});
    }
    Design coupled = grooves(0.5, 40);
    coupled.diffuse = CoupledDiffuse{glm::dvec3{1}};
    add("black and white", coupled, glm::dvec3{0}, glm::dvec3{1});
    add("black", coupled, glm::dvec3{0}, glm::dvec3{0});
    add("one red", coupled, {1, 0, 0}, {1, 0, 0});
    Design needle = with_layer(of(GaussianLobe{1e-4, 1e-4}), UniformLobe{}, 1e-3);
    needle.diffuse = CoupledDiffuse{glm::dvec3{1}};
    add("a white needle in a black haze", needle, glm::dvec3{1}, glm::dvec3{0});
    add("a black needle in a white haze", needle, glm::dvec3{0}, glm::dvec3{1});
}

}  // namespace

std::vector<ExtremeCase> extreme_cases() {
    Cases cases;
    for (const auto add : {add_lobes, add_ratios, add_tilts, add_mixtures, add_pictures, add_scales,
                           add_mean_cosines, add_visibilities, add_materials, add_intensities, add_tints})
        add(cases);
    add_retro_extremes(cases);
    add_bounce_extremes(cases);
    add_coat_extremes(cases);
    return cases;
}

}  // namespace nacre
