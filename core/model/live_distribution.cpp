#include "core/model/live_distribution.h"

#include "core/base/error.h"
#include "core/model/picture_lobe.h"

namespace nacre {

std::shared_ptr<const FacetDistribution> LiveDistribution::of(const Distribution& distribution) {
    if (design_ != distribution) {
        std::vector<std::shared_ptr<const LobeModel>> models(distribution.layers.size());
        try {
            facets_ = std::make_shared<const FacetDistribution>(
                distribution, [&](const Layer& layer, std::size_t index) {
                    return models[index] = model_of(layer, index);
                });
        } catch (const UserError&) {
            facets_.reset();
        }
        design_ = distribution;
        models_ = std::move(models);
        ++revision_;
    }
    return facets_;
}

// The old one of an equal layer wherever it stood, the old one of this layer with a touch of the brush, or a
// new one.
std::shared_ptr<const LobeModel> LiveDistribution::model_of(const Layer& layer, std::size_t index) const {
    for (std::size_t i = 0; i < models_.size(); ++i)
        if (models_[i] && design_->layers[i].lobe == layer.lobe &&
            design_->layers[i].modulation == layer.modulation)
            return models_[i];
    if (index < models_.size() && models_[index])
        if (auto touched = repaint(*models_[index], layer)) return touched;
    return make_lobe(layer);
}

}  // namespace nacre
