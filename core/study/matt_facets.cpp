#include "core/study/matt_facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/facet_lattice.h"

namespace nacre {

MattFacets::MattFacets(const FacetDistribution& p, std::size_t count) {
    for (const Facet& facet : facet_lattice(p, count)) {
        x_.push_back(facet.h.x);
        y_.push_back(facet.h.y);
        z_.push_back(facet.h.z);
        mass_.push_back(facet.mass);
        mean_cosine_ += facet.mass * facet.h.z;
    }
}

double MattFacets::brdf(dvec3 k1, dvec3 k2) const {
    double g1 = 0, g2 = 0, both = 0;
    for (std::size_t i = 0; i < mass_.size(); ++i) {
        const double seen1 = std::max(k1.x * x_[i] + k1.y * y_[i] + k1.z * z_[i], 0.0);
        const double seen2 = std::max(k2.x * x_[i] + k2.y * y_[i] + k2.z * z_[i], 0.0);
        g1 += mass_[i] * seen1;
        g2 += mass_[i] * seen2;
        both += mass_[i] * seen1 * seen2;
    }
    return g1 > 0 && g2 > 0 ? mean_cosine_ * both / (std::numbers::pi * g1 * g2) : 0;
}

}  // namespace nacre
