#include "core/bake/facet_changes.h"

#include <algorithm>

namespace nacre {

FacetChanges::FacetChanges(const std::vector<Facet>& changes) {
    for (const Facet& facet : changes) {
        const dvec3 moment = facet.mass * facet.h;
        x_.push_back(moment.x);
        y_.push_back(moment.y);
        z_.push_back(moment.z);
        mass_.push_back(facet.mass);
        moment_ += moment;
        centre_ += facet.h / static_cast<double>(changes.size());
    }
    for (const Facet& facet : changes) radius_ = std::max(radius_, glm::length(facet.h - centre_));
}

double FacetChanges::projected_area(dvec3 k) const {
    const double distance = glm::dot(k, centre_);
    if (distance >= radius_) return glm::dot(k, moment_);
    if (distance <= -radius_) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < mass_.size(); ++i) {
        const double seen = k.x * x_[i] + k.y * y_[i] + k.z * z_[i];
        sum += seen * mass_[i] > 0 ? seen : 0;
    }
    return sum;
}

}  // namespace nacre
