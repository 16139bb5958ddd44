#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "ui/material_panel.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* model_names[] = {"Schlick", "Dielectric", "Conductor", "None"};
constexpr const char* model_tooltip =
    "F(k\u00b7h), how much a facet mirrors at each angle. Schlick: one colour f0, rising to white at grazing "
    "angles, F = f0 + (1 \u2212 f0)(1 \u2212 k\u00b7h)\u2075 (eq. 31). Dielectric: glass, plastic, "
    "lacquer by index of refraction; conductor: metals by measured eta and k; both by Fresnel's exact "
    "equations. None: a perfect mirror, F = 1, to study the distribution alone.";

double dielectric_f0(double ior) {
    const double r = (ior - 1) / (ior + 1);
    return r * r;
}

double conductor_f0(double eta, double k) {
    return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
}

glm::dvec3 f0_of(const Fresnel& fresnel) {
    if (const auto* schlick = std::get_if<SchlickFresnel>(&fresnel)) return schlick->f0;
    if (const auto* dielectric = std::get_if<DielectricFresnel>(&fresnel))
        return glm::dvec3(dielectric_f0(dielectric->ior));
    if (const auto* conductor = std::get_if<ConductorFresnel>(&fresnel)) {
        glm::dvec3 f0;
        for (int i = 0; i < 3; ++i) f0[i] = conductor_f0(conductor->eta[i], conductor->k[i]);
        return f0;
    }
    return glm::dvec3(1);
}

DielectricFresnel dielectric_of(glm::dvec3 f0) {
    const double root = std::sqrt(std::clamp((f0.x + f0.y + f0.z) / 3, 0.0, 0.66));
    const double ior = (1 + root) / (1 - root);
    return {std::clamp(std::round(ior * 1e4) / 1e4, limits::ior_min, limits::ior_max)};
}

// The artist-friendly inverse of Gulbrandsen 2014 with an edge tint of one half: keeps f0.
ConductorFresnel conductor_of(glm::dvec3 f0) {
    ConductorFresnel conductor;
    for (int i = 0; i < 3; ++i) {
        const double r = std::clamp(f0[i], 0.01, 0.99);
        const double root = std::sqrt(r);
        const double eta = 0.5 * (1 - r) / (1 + r) + 0.5 * (1 + root) / (1 - root);
        const double k2 = (r * (eta + 1) * (eta + 1) - (eta - 1) * (eta - 1)) / (1 - r);
        conductor.eta[i] = std::clamp(eta, limits::eta_min, limits::eta_max);
        conductor.k[i] = std::clamp(std::sqrt(std::max(k2, 0.0)), 0.0, limits::k_max);
    }
    return conductor;
}

Fresnel converted(const Fresnel& from, int kind) {
    const glm::dvec3 f0 = f0_of(from);
    switch (kind) {
        case 0:
            return SchlickFresnel{glm::clamp(f0, 0.0, 1.0)};
        case 1:
            return dielectric_of(f0);
        case 2:
            return conductor_of(f0);
        default:
            return NoFresnel{};
    }
}

struct FresnelFields {
    bool operator()(SchlickFresnel& schlick) const {
        return colour(
            "f0", schlick.f0, SchlickFresnel{}.f0,
            "Reflected colour when looking straight at a facet. About 0.04 (dark grey) for plastics and "
            "glass, strong and coloured for metals. F = f0 + (1 \u2212 f0)(1 \u2212 k\u00b7h)\u2075. Linear "
            "values; the swatch picks as displayed.");
    }
    bool operator()(DielectricFresnel& dielectric) const {
        return slider(
            {.label = "Refraction",
             .low = 1,
             .high = 2.5,
             .least = limits::ior_min,
             .most = limits::ior_max,
             .reset = DielectricFresnel{}.ior,
             .format = "%.3f",
             .logarithmic = false,
             .tooltip = "Index of refraction: water 1.33, plastic 1.5, diamond 2.4. More mirrors more: "
                        "((n \u2212 1)/(n + 1))\u00b2 straight on, 4 % for 1.5."},
            dielectric.ior);
    }
    bool operator()(ConductorFresnel& conductor) const {
        const bool eta = slider(
            {.label = "eta",
             .low = 0.05,
             .high = 10,
             .least = limits::eta_min,
             .most = limits::eta_max,
             .reset = 1,
             .format = "%.3g",
             .logarithmic = true,
             .tooltip = "Real part of the index of refraction eta + i k for red, green and blue. Straight "
                        "on a facet mirrors ((eta \u2212 1)\u00b2 + k\u00b2)/((eta + 1)\u00b2 + k\u00b2)."},
            conductor.eta);
        return slider({.label = "k",
                       .low = 0,
                       .high = 10,
                       .least = 0,
                       .most = limits::k_max,
                       .reset = 3,
                       .format = "%.3g",
                       .logarithmic = false,
                       .tooltip =
                           "Imaginary part, the absorption, for red, green and blue: the larger, the more "
                           "mirror-like. ((eta \u2212 1)\u00b2 + k\u00b2)/((eta + 1)\u00b2 + k\u00b2) "
                           "straight on."},
                      conductor.k) ||
               eta;
    }
    bool operator()(NoFresnel&) const {
        dim_text("Every facet is a perfect mirror (F = 1).");
        return false;
    }
};

}  // namespace

bool fresnel_panel(Fresnel& fresnel) {
    int kind = static_cast<int>(fresnel.index());
    bool changed = combo("Reflection", kind, model_names, model_tooltip);
    if (changed) fresnel = converted(fresnel, kind);
    return std::visit(FresnelFields{}, fresnel) || changed;
}

}  // namespace nacre::ui
