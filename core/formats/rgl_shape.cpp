#include "core/formats/rgl_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/brdf.h"
#include "core/formats/rgl_place.h"
#include "core/image/luminance.h"

namespace nacre {
namespace {

// A table of what else there is. Beneath a coat that is a highlight too, and wants more nodes.
constexpr int plain_columns = 33, coated_columns = 257, turned_rows = 65;

constexpr double horizon = 0.1;  // cosine; the lowest direction that counts for that table

// Spread over the hemisphere, none of them close to the horizon.
std::vector<dvec3> incident_directions() {
    std::vector<dvec3> directions;
    for (const double sine : {0.2, 0.55, 0.85})
        for (int i = 0; i < 8; ++i) {
            const double phi = 2 * std::numbers::pi * (i + 0.3 + sine) / 8;
            directions.push_back({sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - sine * sine)});
        }
    return directions;
}

}  // namespace

RglShape::RglShape(const Tables& tables)
    : tables_(tables),
      coated_(tables.shading.kinds.coated()),
      columns_(coated_ ? coated_columns : plain_columns),
      rows_(tables.needs.symmetry.symmetry == Symmetry::isotropic ? 1 : turned_rows) {
    std::vector<double> found;
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x) {
            const dvec2 place{unit_place(x, columns_), rows_ == 1 ? 0.5 : unit_place(y, rows_)};
            const double value = other_facets(rgl_facet(place));
            // Facets close to the horizon mirror nothing over it.
            found.push_back(value >= 0 ? value : found.back());
        }
    if (std::any_of(found.begin(), found.end(), [](double v) { return v > 0; })) others_ = std::move(found);
}

RglShape::Pair RglShape::pair(const Direction& from, const Direction& to, dvec3 m) const {
    const auto& shading = tables_.shading;
    if (coated_) {
        const double cosine = glm::dot(from.outside, m);
        const double per_facet =
            shading.dielectric_reflectance(shading.surface.coat_ior, cosine) / (4 * from.coat_g * to.coat_g);
        const dvec3 others = shading.coated_brdf_of(from, to) - shading.coat_specular(from, to);
        return {dvec3(per_facet), glm::max(others, dvec3(0))};
    }
    const auto between = shading.half_vector(from.k, to.k);
    const double mirrored_share = shading.kinds.retro ? 1 - shading.surface.retro : 1;
    const dvec3 per_density = shading.specular_of(from, to, between, 1) * shading.surface.ks * mirrored_share;
    const dvec3 all = shading.brdf_of(from, to);
    return {per_density * shading.surface.N,
            glm::max(all - per_density * shading.density(between.h), dvec3(0))};
}

// In the mean over pairs of directions; negative where none has m half way between.
double RglShape::other_facets(dvec3 m) const {
    double sum = 0;
    int count = 0;
    for (const dvec3 k1 : incident_directions()) {
        const dvec3 k2 = mirrored(k1, m);
        if (k2.z < horizon) continue;
        const Pair found = pair(direction(k1), direction(k2), m);
        sum += luminance(found.others) / std::max(luminance(found.per_facet), 1e-9);
        ++count;
    }
    return count > 0 ? sum / count : -1;
}

double RglShape::facets(dvec3 m) const {
    return coated_ ? tables_.coat_facets->density(m)
                   : tables_.distribution->density(m) / tables_.shading.surface.N;
}

double RglShape::others_at(dvec3 m) const {
    if (others_.empty()) return 0;
    const dvec2 at = rgl_place(m);
    const double x = at.x * (columns_ - 1), y = at.y * (rows_ - 1);
    const int i = std::min(static_cast<int>(x), columns_ - 2),
              j = std::clamp(static_cast<int>(y), 0, std::max(rows_ - 2, 0));
    const double s = x - i, t = rows_ > 1 ? y - j : 0;
    const double* const first = &others_[static_cast<std::size_t>(j * columns_ + i)];
    const double* const second = rows_ > 1 ? first + columns_ : first;
    return (first[0] * (1 - s) + first[1] * s) * (1 - t) + (second[0] * (1 - s) + second[1] * s) * t;
}

double RglShape::sigma(dvec3 k) const {
    return tables_.distribution->projected_area(k) / tables_.shading.surface.N;
}

dvec3 RglShape::over_ndf(const Direction& from, dvec3 k2, dvec3 m) const {
    if (!(k2.z > 0)) return dvec3(0);
    const Pair found = pair(from, direction(k2), m);
    const double lit = facets(m), all = ndf(m);
    if (!(all > 0)) return found.per_facet * k2.z;
    return (found.per_facet * lit + found.others) * k2.z / all;
}

}  // namespace nacre
