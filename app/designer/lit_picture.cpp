#include "app/designer/lit_picture.h"

#include <cmath>

#include "app/preview/filmic.h"
#include "core/bake/brdf_pairs.h"
#include "core/image/srgb.h"
#include "core/model/float_shading.h"

namespace nacre {
namespace {

std::uint8_t byte_of(double radiance) {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(filmic(radiance))));
}

}  // namespace

HemispherePicture lit_picture(const Tables& tables, glm::dvec3 light, const HemisphereView& view,
                              int divisor) {
    const Shading<float> shading = in_float(tables.shading);
    std::vector<glm::vec3> k, rho;
    return hemisphere_picture(view, divisor, [&](std::span<const dvec3> row) {
        k.assign(row.begin(), row.end());
        rho.resize(row.size());
        evaluate_pairs(shading, k, k, rho);
        std::vector<glm::u8vec3> shown;
        shown.reserve(row.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const dvec3 radiance = dvec3(rho[i]) * light * std::fmax(row[i].z, 0.0);
            shown.emplace_back(byte_of(radiance.x), byte_of(radiance.y), byte_of(radiance.z));
        }
        return shown;
    });
}

}  // namespace nacre
