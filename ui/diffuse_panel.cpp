#include <algorithm>

#include "ui/material_panel.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* model_names[] = {"None", "Lambertian", "Coupled", "Metal"};
constexpr const char* model_tooltip =
    "Light that comes back without a mirror reflection. Lambertian: fixed shares, kd albedo/\u03c0 + ks "
    "specular. Coupled: the diffuse part takes exactly what the highlight leaves, so it fades toward grazing "
    "angles as lacquer does: albedo c (1 \u2212 R(k1))(1 \u2212 R(k2)) (eq. 28). Metal: light that bounces "
    "between facets, the same in the metal's own colour.";
constexpr const char* albedo_tooltip =
    "Directional albedo of the diffuse part: how much of the light that reaches it comes back, per colour. "
    "Linear values; the swatch picks as displayed.";

glm::dvec3 albedo_of(const Diffuse& diffuse) {
    if (const auto* lambertian = std::get_if<LambertianDiffuse>(&diffuse)) return lambertian->albedo;
    if (const auto* coupled = std::get_if<CoupledDiffuse>(&diffuse)) return coupled->albedo;
    return glm::dvec3(0.5);
}

Diffuse converted(const Diffuse& from, int kind) {
    switch (kind) {
        case 0:
            return NoDiffuse{};
        case 1: {
            LambertianDiffuse lambertian;
            lambertian.albedo = albedo_of(from);
            return lambertian;
        }
        case 2:
            return CoupledDiffuse{albedo_of(from)};
        default:
            return MetalDiffuse{};
    }
}

SliderSpec share_spec(const char* label, const char* tooltip) {
    return {.label = label,
            .low = 0,
            .high = 1,
            .least = 0,
            .most = 1,
            .reset = 0.5,
            .format = "%.3f",
            .logarithmic = false,
            .tooltip = tooltip};
}

struct DiffuseFields {
    bool operator()(NoDiffuse&) const { return false; }
    bool operator()(LambertianDiffuse& lambertian) const {
        bool changed = colour("Albedo", lambertian.albedo, glm::dvec3(0.5), albedo_tooltip);
        if (slider(share_spec("Diffuse kd",
                              "Share of the diffuse part: kd albedo/\u03c0. kd + ks stays at most 1."),
                   lambertian.kd)) {
            lambertian.ks = std::min(lambertian.ks, 1 - lambertian.kd);
            changed = true;
        }
        if (slider(share_spec("Specular ks",
                              "Share of the highlight: ks times the specular term. kd + ks stays at most 1."),
                   lambertian.ks)) {
            lambertian.kd = std::min(lambertian.kd, 1 - lambertian.ks);
            changed = true;
        }
        return changed;
    }
    bool operator()(CoupledDiffuse& coupled) const {
        return colour("Albedo", coupled.albedo, glm::dvec3(0.5), albedo_tooltip);
    }
    bool operator()(MetalDiffuse&) const {
        dim_text("Takes its colour from the reflection's f0.");
        return false;
    }
};

}  // namespace

bool diffuse_panel(Diffuse& diffuse) {
    int kind = static_cast<int>(diffuse.index());
    bool changed = combo("Diffuse", kind, model_names, model_tooltip);
    if (changed) diffuse = converted(diffuse, kind);
    return std::visit(DiffuseFields{}, diffuse) || changed;
}

}  // namespace nacre::ui
