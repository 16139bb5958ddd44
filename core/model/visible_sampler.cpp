#include "core/model/visible_sampler.h"

namespace nacre {

VisibleSampler::VisibleSampler(const std::vector<PlacedLobe>& lobes, dvec3 k) : lobes_(lobes), k_(k) {
    for (const PlacedLobe& placed : lobes) {
        parts_.push_back(placed.scale * placed.lobe->projected_area(glm::transpose(placed.frame) * k));
        area_ += parts_.back();
    }
}

dvec3 VisibleSampler::operator()(Random& random) const {
    double left = uniform_random(random) * area_;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (parts_[i] > 0) chosen = i;
        if (left < parts_[i]) break;
        left -= parts_[i];
    }
    const PlacedLobe& placed = lobes_[chosen];
    return placed.frame * placed.lobe->sample_visible(glm::transpose(placed.frame) * k_, random);
}

}  // namespace nacre
