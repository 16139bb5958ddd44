#include "core/study/extremes.h"

#include <fmt/core.h>

#include <cmath>

namespace nacre {
namespace {

using Cases = std::vector<ExtremeCase>;

constexpr double infinity = limits::infinity;
// The most that the bake may claim as the error of g: its tolerance, and more of a p that leans.
constexpr double usual_claim = 1.5e-3, leaning_claim = 4e-3;
// The same of R, where it turns within the last cell before the horizon or within a thousandth of a degree of
// azimuth.
constexpr double layer_claim = 0.05;
// Of a p that leans, on the side where it turns away: under clamp R falls to 0 closer to the horizon than a
// cell, from as much as it is there; without, it has no bound.
struct LeaningClaims {
    double clamped, unclamped;
};
constexpr LeaningClaims weakly_correlated{0.15, 0.9}, strongly_correlated{1, 1.5};
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

Design grooves(double width, double tilt) {
    return with_layer(of(GaussianLobe{width, width}, tilt), GaussianLobe{width, width}, 1, tilt, 180);
}

// A picture from a function of the texel's column and row.
template <class Function>
Picture picture(int side, const Function& value) {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = side;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            raster->values.push_back(static_cast<float>(value(column, row)));
    return {{}, std::move(raster)};
}

Picture one_texel(int side, int at_column, int at_row) {
    return picture(side, [=](int column, int row) { return column == at_column && row == at_row ? 1 : 0; });
}

Picture blob(double brightness) {
    return picture(16, [=](int column, int row) {
        return brightness * std::exp(-0.05 * ((column - 9) * (column - 9) + (row - 6) * (row - 6)));
    });
}

Design modulated(Lobe lobe, Picture image, double strength) {
    Design design = of(std::move(lobe));
    design.distribution.layers.front().modulation = Modulation{std::move(image), strength};
    return design;
}

void add_widths(Cases& cases) {
    for (const double width : {limits::width_min, 1e-4, 1e-2, 1.0, 1e2, 1e4, limits::width_max}) {
        auto add = [&](const char* lobe, Design design) {
            cases.push_back({"widths", fmt::format("{} {:g}", lobe, width), std::move(design)});
        };
        add("gaussian", of(GaussianLobe{width, width}));
        add("inverse gaussian", of(InverseGaussianLobe{width}));
        add("ggx", of(GgxLobe{width, width}));
        add("beckmann", of(BeckmannLobe{width, width}));
    }
    cases.push_back(
        {"widths", "curve, a ring 0.002 degrees wide", of(CurveLobe{{{20, 0}, {20.001, 1}, {20.002, 0}}})});
    cases.push_back({"widths", "curve, a step at the horizon", of(CurveLobe{{{0, 1}, {90, 1}}})});
    cases.push_back({"widths", "curve down to the nadir", of(CurveLobe{{{0, 1}, {180, 0.2}}})});
}

void add_ratios(Cases& cases) {
    struct Widths {
        double x, y;
    };
    for (const Widths w : {Widths{1e-4, 1e2}, {1e-3, 1e3}, {1e-2, 1e4}, {0.1, 1}}) {
        auto add = [&](const char* lobe, Design design) {
            cases.push_back({"ratios", fmt::format("{} ({:g}, {:g})", lobe, w.x, w.y), std::move(design)});
        };
        add("gaussian", of(GaussianLobe{w.x, w.y}));
        add("ggx", of(GgxLobe{w.x, w.y}));
        if (w.x < 1e-3) cases.back().albedo_claim = layer_claim;
        add("beckmann", of(BeckmannLobe{w.x, w.y}));
        if (w.x < 1e-3) cases.back().albedo_claim = layer_claim;
    }
    for (const double width : {1e-4, 1.0, 1e4, infinity})
        cases.push_back(
            {"ratios", fmt::format("gaussian ({:g}, infinity)", width), of(GaussianLobe{width, infinity})});
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
            leaning_claim);
    add("ggx 0.0001 by 45 degrees", of(GgxLobe{1e-4, 1e-4}, 45), usual_claim);
    cases.back().albedo_claim = layer_claim;
    add("inverse gaussian 0.01 by 89 degrees", of(InverseGaussianLobe{0.01}, 89), usual_claim);
    add("gaussian (0.01, infinity) by 89 degrees", of(GaussianLobe{0.01, infinity}, 89), usual_claim);
    add("gaussian (infinity, 0.01) by 89 degrees", of(GaussianLobe{infinity, 0.01}, 89), leaning_claim);
    add("grooves of 0.001", grooves(1e-3, 20), leaning_claim);
    add("grooves of 0.01", grooves(0.01, 20), usual_claim);
    add("grooves of 0.1", grooves(0.1, 20), usual_claim);
    add("grooves of 0.01 by 80 degrees", grooves(0.01, 80), usual_claim);
    // The paper's (sec. 6.4), N doubled by hand.
    Design slanted = of(GaussianLobe{0.5, infinity}, 40);
    slanted.distribution.mean_cosine_scale = 2;
    slanted.shadowing.model = CorrelatedMasking{};
    add("slanted velvet", slanted, usual_claim);
    slanted.shadowing.clamp = false;
    add("slanted velvet, no clamp", slanted, leaning_claim);
    cases.back().albedo_claim = layer_claim;
}

void add_mixtures(Cases& cases) {
    for (const double weight : {1e-6, 1e-3, 1.0})
        cases.push_back({"mixtures", fmt::format("needle 0.0001 of weight {:g} over a haze", weight),
                         with_layer(of(UniformLobe{}), GaussianLobe{1e-4, 1e-4}, weight)});
    cases.push_back({"mixtures", "haze of weight 1e-06 over a leaning needle",
                     with_layer(of(GaussianLobe{1e-3, 1e-3}, 30), UniformLobe{}, 1e-6)});
    cases.back().area_claim = leaning_claim;
    cases.back().albedo_claim = layer_claim;
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
        cases.back().albedo_claim = layer_claim;
    };
    cases.push_back({"pictures", "one texel of 1", painted(one_texel(1, 0, 0))});
    add_texel("one texel of 64 x 64, upright", 64, 32, 32);
    add_texel("one texel of 256 x 256, leaning", 256, 170, 90);
    add_texel("one texel of 64 x 64, at the horizon", 64, 0, 32);
    cases.push_back({"pictures", "one texel outside the disk", painted(one_texel(64, 0, 0)), no_facets});
    cases.push_back({"pictures", "checkerboard 64 x 64",
                     painted(picture(64, [](int column, int row) { return (column + row) % 2; }))});
    cases.push_back({"pictures", "black", painted(picture(32, [](int, int) { return 0; })), no_facets});
    cases.push_back({"pictures", "modulation by black",
                     modulated(GaussianLobe{}, picture(8, [](int, int) { return 0; }), 1), no_facets});
    cases.push_back({"pictures", "needle 0.0001 modulated by a checkerboard",
                     modulated(GaussianLobe{1e-4, 1e-4},
                               picture(64, [](int column, int row) { return (column + row) % 2; }), 1)});
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
    cases.push_back({"mean cosine", "whole sphere alone, N = 0", sphere, faces_down});
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

void add_visibilities(Cases& cases) {
    struct Model {
        const char* name;
        Shadowing shadowing;
        double tilt;
        LeaningClaims claims = weakly_correlated;
    };
    // The narrowest t upright: on a p that leans the reference takes a minute for one R.
    for (const Model& m :
         {Model{"uncorrelated", {UncorrelatedMasking{}}, 50},
          {"correlated, 0.1 degrees", {CorrelatedMasking{limits::correlation_min}}, 0},
          {"correlated, 15 degrees", {CorrelatedMasking{}}, 50},
          {"correlated, 180 degrees", {CorrelatedMasking{limits::correlation_max}}, 50, strongly_correlated},
          {"Smith", {SmithCorrelatedMasking{}}, 50, strongly_correlated}})
        for (const bool clamp : {true, false}) {
            Design design = of(GaussianLobe{0.3, 0.3}, m.tilt);
            design.shadowing = m.shadowing;
            design.shadowing.clamp = clamp;
            design.diffuse = CoupledDiffuse{};
            cases.push_back({"visibility", fmt::format("{}{}", m.name, clamp ? "" : ", no clamp"), design});
            if (m.tilt == 0) continue;
            cases.back().area_claim = leaning_claim;
            cases.back().albedo_claim = clamp ? m.claims.clamped : m.claims.unclamped;
        }
}

void add_materials(Cases& cases) {
    struct Reflectance {
        const char* name;
        Fresnel fresnel;
    };
    const Reflectance reflectances[] = {
        {"f0 = 0", SchlickFresnel{glm::dvec3{0}}},
        {"f0 = 1", SchlickFresnel{glm::dvec3{1}}},
        {"f0 = (0, 0.5, 1)", SchlickFresnel{{0, 0.5, 1}}},
        {"ior 1", DielectricFresnel{1}},
        {"ior 1 + 1e-12", DielectricFresnel{1 + 1e-12}},
        {"ior 10", DielectricFresnel{limits::ior_max}},
        {"index 1", ConductorFresnel{glm::dvec3{1}, glm::dvec3{0}}},
        {"eta 0.001, k 0", ConductorFresnel{glm::dvec3{limits::eta_min}, glm::dvec3{0}}},
        {"eta and k 100", ConductorFresnel{glm::dvec3{limits::eta_max}, glm::dvec3{limits::k_max}}},
        {"eta (0.001, 1, 100), k (100, 0, 1e-6)", ConductorFresnel{{1e-3, 1, 100}, {100, 0, 1e-6}}},
        {"F = 1", NoFresnel{}}};
    const std::pair<const char*, Diffuse> diffuses[] = {
        {"no diffuse", NoDiffuse{}},
        {"Lambertian", LambertianDiffuse{0.5, 0.5, glm::dvec3{1}}},
        {"coupled", CoupledDiffuse{glm::dvec3{1}}},
        {"metal", MetalDiffuse{}}};
    for (const Reflectance& reflectance : reflectances)
        for (const auto& [name, diffuse] : diffuses) {
            Design design = of(GgxLobe{0.3, 0.3});
            design.fresnel = reflectance.fresnel;
            design.diffuse = diffuse;
            cases.push_back({"materials", fmt::format("{}, {}", reflectance.name, name), design});
        }
}

}  // namespace

std::vector<ExtremeCase> extreme_cases() {
    Cases cases;
    for (const auto add : {add_widths, add_ratios, add_tilts, add_mixtures, add_pictures, add_scales,
                           add_mean_cosines, add_visibilities, add_materials})
        add(cases);
    return cases;
}

}  // namespace nacre
