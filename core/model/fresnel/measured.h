#pragma once

#include <tuple>

#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/parameter.h"
#include "core/model/spectral/materials.h"

namespace nacre {

// Fresnel's equations for a measured index n + i k at every wavelength, integrated to a colour.
struct MeasuredFresnel {
    Material material = Material::gold;
    bool operator==(const MeasuredFresnel&) const = default;

    static constexpr const char* name = "measured";
    static constexpr const char* label = "Measured";
    static constexpr const char* explanation =
        "A metal, semiconductor or oxide by name: Fresnel's equations with its measured n + i k at every "
        "wavelength, "
        "made a colour under D65.";
    static constexpr const char* note = "";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{ChoiceParameter<MeasuredFresnel, Material, material_names.size()>{
            .member = &MeasuredFresnel::material,
            .text = {"material", "Material##Measured material",
                     "Whose n and k were measured. Sources: docs/materials.md. The swatch is the colour seen "
                     "straight "
                     "on."},
            .names = material_names,
            .labels = material_labels,
            .swatch = material_colour}};
    }

    static constexpr bool is_metal = true;
    static constexpr const char* formula = curve_formula;
    static constexpr FresnelTables tables = FresnelTables::exact;
    static constexpr bool is_curve = true;
    ShaderFresnel shader(double above = 1) const;

    // As integrated, not clipped.
    Reflectance reflectance(double above = 1) const;
    // The material whose colour straight on and at 82 degrees is nearest.
    static MeasuredFresnel of_reflectance(const Reflectance& wanted);
    // Straight on, clipped; `index` counts the materials.
    static glm::dvec3 material_colour(std::size_t index);
};

}  // namespace nacre
