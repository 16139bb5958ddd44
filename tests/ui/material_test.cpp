#include "ui/material_panel.h"

#include "core/design/design.h"
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
    Diffuse diffuse = CoupledDiffuse{glm::dvec3(0.4, 0.05, 0.1)};
    PanelRig rig([&] { ui::diffuse_panel(diffuse); });
    rig.frame(3);
    CHECK(diffuse == Diffuse(CoupledDiffuse{glm::dvec3(0.4, 0.05, 0.1)}));
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
    rig.enter_number("Refraction", "0.3");
    CHECK(std::get<DielectricFresnel>(fresnel).ior == DielectricFresnel{}.ior);
}

TEST_CASE("material: masking") {
    Shadowing shadowing{.model = ShadowingModel::correlated};
    double scale = 1;
    PanelRig rig([&] { ui::shadowing_panel(shadowing, scale); });
    rig.enter_number("Correlation", "30");
    CHECK(shadowing.width == 30);
    rig.click("Clamp");
    CHECK(!shadowing.clamp);
    rig.enter_number("Mean cosine", "2");
    CHECK(scale == 2);
    shadowing.model = ShadowingModel::uncorrelated;
    rig.frame();
    CHECK(!rig.has("Correlation"));
}
