#include "ui/material_panel.h"

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
