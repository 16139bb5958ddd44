// Measured indices of refraction by name.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <string_view>

namespace nacre {

// In the order of material_list.inc.
enum class Material : int {
#define MATERIAL(key, ...) key,
#include "core/model/spectral/material_list.inc"
#undef MATERIAL
};

// In files.
inline constexpr std::array material_names = {
#define MATERIAL(key, ...) std::string_view(#key),
#include "core/model/spectral/material_list.inc"
#undef MATERIAL
};

// In the window.
inline constexpr std::array material_labels = {
#define MATERIAL(key, label, ...) static_cast<const char*>(label),
#include "core/model/spectral/material_list.inc"
#undef MATERIAL
};

struct MeasuredIndex {
    double wavelength;  // nm
    double n, k;
};

struct MaterialData {
    const char* entry;                       // of the database of refractiveindex.info
    const char* source;                      // who measured it
    std::span<const MeasuredIndex> indices;  // wavelengths rise, from 380 nm or less to 780 nm or more
};

const MaterialData& material_data(Material material);

// n + i k at a wavelength from 380 to 780 nm, straight lines between what was measured.
std::complex<double> index_at(Material material, double wavelength);

}  // namespace nacre
