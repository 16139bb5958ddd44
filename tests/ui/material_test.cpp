#include "ui/material_panel.h"

#include <cmath>

#include "core/design/design.h"
#include "core/shading/surface.h"
#include "tests/ui/panel_rig.h"

using namespace nacre;

TEST_CASE("material: kd + ks never exceeds 1") {
    Diffuse diffuse = LambertianDiffuse{};
    PanelRig rig([&] { ui::diffuse_panel(diffuse); });
    const auto& lambertian = std::get<LambertianDiffuse>(diffuse);
    for (const float to : {0.9f, 0.1f, 0.7f, 1.4f}) {
        rig.drag("Diffuse kd", {0.5f, 0.5f}, {to, 0.5f});
        CHECK(lambertian.kd + lambertian.ks <= 1);
        rig.drag("Specular ks", {0.2f, 0.5f}, {1.0f - to / 3, 0.5f});
        CHECK(lambertian.kd + lambertian.ks <= 1);
    }
    rig.enter_number("Diffuse kd", "1");
    CHECK(lambertian.kd == 1);
    CHECK(lambertian.ks == 0);
}

TEST_CASE("material: no more than everything goes back to where it came from") {
    Retro retro;
    PanelRig rig([&] { ui::retro_panel(retro); });
    rig.drag("Retro-reflection", {0.01f, 0.5f}, {0.5f, 0.5f});
    CHECK(retro.weight == doctest::Approx(0.5).epsilon(0.05));
    rig.enter_number("Retro-reflection", "1.5");
    CHECK(retro.weight <= 1);
    rig.enter_number("Retro-reflection", "0.25");
    CHECK(retro.weight == 0.25);
}

TEST_CASE("material: a coat is chosen, and its roughness stays within its bounds") {
    Coat coat;
    PanelRig rig([&] { ui::coat_panel(coat); });
    rig.choose("Coat", "Clear coat");
    REQUIRE(std::holds_alternative<ClearCoat>(coat));
    rig.enter_number("Coat roughness", "0.25");
    CHECK(std::get<ClearCoat>(coat).roughness == 0.25);
    rig.enter_number("Coat roughness", "0");
    CHECK(std::get<ClearCoat>(coat).roughness >= limits::coat_roughness_min);
    rig.choose("Coat", "None");
    CHECK(coat == Coat(NoCoat{}));
}

TEST_CASE("material: changing the diffuse model keeps the colour") {
    const glm::dvec3 albedo(0.4, 0.05, 0.1);
    Diffuse diffuse = CoupledDiffuse{albedo};
    PanelRig rig([&] { ui::diffuse_panel(diffuse); });
    rig.choose("Diffuse", "Lambertian");
    REQUIRE(std::holds_alternative<LambertianDiffuse>(diffuse));
    CHECK(std::get<LambertianDiffuse>(diffuse).albedo == albedo);
    CHECK(std::get<LambertianDiffuse>(diffuse).kd == LambertianDiffuse{}.kd);
    rig.choose("Diffuse", "Coupled");
    CHECK(diffuse == Diffuse(CoupledDiffuse{albedo}));
    rig.choose("Diffuse", "Metal");
    CHECK(diffuse == Diffuse(MetalDiffuse{}));
    rig.choose("Diffuse", "None");
    CHECK(diffuse == Diffuse(NoDiffuse{}));
}

TEST_CASE("material: changing the Fresnel model keeps f0 as nearly as the other can have it") {
    Fresnel fresnel = DielectricFresnel{1.5};
    PanelRig rig([&] { ui::fresnel_panel(fresnel); });
    rig.choose("Fresnel", "Schlick");
    REQUIRE(std::holds_alternative<SchlickFresnel>(fresnel));
    for (int i = 0; i < 3; ++i)
        CHECK(std::get<SchlickFresnel>(fresnel).f0[i] == doctest::Approx(0.04).epsilon(1e-12));
    const glm::dvec3 gold(0.95, 0.7, 0.3);
    fresnel = SchlickFresnel{gold};
    rig.choose("Fresnel", "Conductor");
    REQUIRE(std::holds_alternative<ConductorFresnel>(fresnel));
    for (int i = 0; i < 3; ++i)
        CHECK(normal_reflectance(fresnel)[i] == doctest::Approx(gold[i]).epsilon(1e-9));
    rig.choose("Fresnel", "Dielectric");
    CHECK(normal_reflectance(fresnel).x == doctest::Approx((gold.x + gold.y + gold.z) / 3).epsilon(1e-3));
    rig.choose("Fresnel", "None");
    CHECK(fresnel == Fresnel(NoFresnel{}));
}

TEST_CASE("material: a colour that is not touched keeps all its digits") {
    const glm::dvec3 gold(0.9999999, 0.7123456789, 0.2987654321);
    Fresnel fresnel = SchlickFresnel{gold};
    PanelRig rig([&] { ui::fresnel_panel(fresnel); });
    rig.frame(5);
    CHECK(std::get<SchlickFresnel>(fresnel).f0 == gold);
    rig.drag("f0", {0.1f, 0.5f}, {0.0f, 0.5f});
    CHECK(std::get<SchlickFresnel>(fresnel).f0.x < gold.x);
    CHECK(std::get<SchlickFresnel>(fresnel).f0.z == gold.z);
}

TEST_CASE("material: conductors and dielectrics have their sliders within the limits") {
    Fresnel fresnel = ConductorFresnel{};
    PanelRig rig([&] { ui::fresnel_panel(fresnel); });
    rig.enter_number("eta green", "0,001");
    CHECK(std::get<ConductorFresnel>(fresnel).eta.y == limits::eta_min);
    rig.enter_number("eta green", "0");
    CHECK(std::get<ConductorFresnel>(fresnel).eta.y == limits::eta_min);
    CHECK(rig.has("eta green problem"));
    rig.enter_number("k blue", "100");
    CHECK(std::get<ConductorFresnel>(fresnel).k.z == limits::k_max);
    rig.enter_number("k blue", "500");
    CHECK(std::get<ConductorFresnel>(fresnel).k.z == limits::k_max);
    CHECK(rig.has("k blue problem"));
    fresnel = DielectricFresnel{};
    rig.enter_number("IOR", "0.3");
    CHECK(std::get<DielectricFresnel>(fresnel).ior == DielectricFresnel{}.ior);
}

TEST_CASE("material: gold by a colour becomes a conductor of that colour, not a red one") {
    const glm::dvec3 gold(1, 0.71, 0.29);
    Fresnel fresnel = SchlickFresnel{gold};
    PanelRig rig([&] { ui::fresnel_panel(fresnel); });
    rig.choose("Fresnel", "Conductor");
    const auto& conductor = std::get<ConductorFresnel>(fresnel);
    for (int i = 0; i < 3; ++i) {
        CHECK(conductor.eta[i] < 3);
        CHECK(conductor.k[i] < 5);
        CHECK(std::fabs(normal_reflectance(fresnel)[i] - gold[i]) < 3e-3);
    }
    rig.choose("Fresnel", "F82");
    CHECK(std::get<F82Fresnel>(fresnel).f0.y == doctest::Approx(gold.y).epsilon(1e-6));
    rig.choose("Fresnel", "Measured");
    CHECK(fresnel == Fresnel(MeasuredFresnel{Material::gold}));
}

TEST_CASE("material: a measured material is chosen by name, and lies under films") {
    Fresnel fresnel = MeasuredFresnel{};
    PanelRig rig([&] { ui::fresnel_panel(fresnel); });
    rig.choose("Measured material", "Copper");
    CHECK(fresnel == Fresnel(MeasuredFresnel{Material::copper}));
    rig.choose("Fresnel", "Thin film");
    CHECK(fresnel == Fresnel(FilmFresnel{MeasuredFresnel{Material::copper}}));
    rig.choose("Measured material", "Silver");
    rig.enter_number("Thickness 1", "450");
    rig.click("Add film");
    rig.enter_number("Film IOR 2", "2.25");
    const std::vector<FilmLayer>& stack = std::get<FilmFresnel>(fresnel).stack;
    REQUIRE(stack.size() == 2);
    CHECK(stack[0].ior == 1.5);
    CHECK(stack[0].thickness == 450);
    CHECK(stack[1].ior == 2.25);
    CHECK(stack[1].thickness == FilmLayer{}.thickness);
    CHECK(std::get<FilmFresnel>(fresnel).over == FilmFresnel::Base(MeasuredFresnel{Material::silver}));
    rig.click("Remove film");
    rig.click("Remove film");
    rig.click("Remove film");
    CHECK(std::get<FilmFresnel>(fresnel).stack.empty());
    rig.choose("Film over", "Dielectric");
    rig.enter_number("IOR", "1.33");
    CHECK(std::get<FilmFresnel>(fresnel).over == FilmFresnel::Base(DielectricFresnel{1.33}));
}

TEST_CASE("material: the points of a drawn curve keep their order") {
    Fresnel fresnel = CurveFresnel{{{0, glm::dvec3(0.5)}, {80, glm::dvec3(1)}}};
    PanelRig rig([&] { ui::fresnel_panel(fresnel); });
    const auto& points = std::get<CurveFresnel>(fresnel).points;
    rig.click("Add point");
    REQUIRE(points.size() == 3);
    CHECK(points[2].theta == 85);
    rig.enter_number("Angle 2", "40");
    CHECK(points[1].theta == 40);
    rig.enter_number("Angle 2", "86");
    CHECK(points[1].theta < points[2].theta);
    rig.enter_number("Colour 3 red", "0.25");
    CHECK(points[2].colour == glm::dvec3(0.25, 1, 1));
    for (int i = 0; i < 4; ++i) rig.click("Remove point");
    CHECK(points.size() == 1);
    for (int i = 0; i < 70; ++i) rig.click("Add point");
    CHECK(points.size() <= limits::fresnel_points_max);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) CHECK(points[i].theta < points[i + 1].theta);
    CHECK(points.back().theta <= 90);
}

TEST_CASE("material: masking") {
    Shadowing shadowing{.model = CorrelatedMasking{}};
    double scale = 1;
    PanelRig rig([&] { ui::shadowing_panel(shadowing, scale); });
    rig.enter_number("Correlation", "30");
    CHECK(std::get<CorrelatedMasking>(shadowing.model).width == 30);
    rig.click("Clamp");
    CHECK(!shadowing.clamp);
    rig.enter_number("Mean cosine", "2");
    CHECK(scale == 2);
    shadowing.model = UncorrelatedMasking{};
    rig.frame();
    CHECK(!rig.has("Correlation"));
}
