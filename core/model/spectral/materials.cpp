#include "core/model/spectral/materials.h"

#include <algorithm>
#include <iterator>

namespace nacre {
namespace {

#define MATERIAL(key, label, entry, source, ...) constexpr MeasuredIndex key##_indices[] = {__VA_ARGS__};
#include "core/model/spectral/material_list.inc"
#undef MATERIAL

constexpr MaterialData materials[] = {
#define MATERIAL(key, label, entry, source, ...) {entry, source, key##_indices},
#include "core/model/spectral/material_list.inc"
#undef MATERIAL
};

}  // namespace

const MaterialData& material_data(Material material) { return materials[static_cast<std::size_t>(material)]; }

std::complex<double> index_at(Material material, double wavelength) {
    const auto indices = material_data(material).indices;
    auto above =
        std::lower_bound(std::next(indices.begin()), std::prev(indices.end()), wavelength,
                         [](const MeasuredIndex& index, double value) { return index.wavelength < value; });
    const MeasuredIndex &a = *std::prev(above), &b = *above;
    const double t = (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
    return {a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

}  // namespace nacre
