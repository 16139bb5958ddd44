// The part of a layer that the tools paint: its own picture, or its mask.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/model/layer.h"

namespace nacre {

enum class LayerPart { lobe, mask };

// A painted lobe's picture, or a modulation's; null where the layer has none.
Picture* part_picture(Layer& layer, LayerPart part);
const Picture* part_picture(const Layer& layer, LayerPart part);
inline bool has_part(const Layer& layer, LayerPart part) { return part_picture(layer, part) != nullptr; }

// Its picture as the tools read it (see paintable()); the layer has the part.
std::shared_ptr<const Raster> part_raster(const Layer& layer, LayerPart part);

// A mask that hides nothing.
Modulation open_mask();

// A part of a layer while it is painted.
class LayerPaint {
  public:
    // Of the chosen layer, which is made ready: enabled where it has facets, its picture held in the design,
    // and with room for its weight to grow. Where it should be a painted lobe and is none, a new painted
    // layer is added after it and chosen. Nothing where that is impossible.
    static std::optional<LayerPaint> open(Distribution& distribution, std::size_t& chosen, LayerPart part);

    std::size_t layer() const { return layer_; }
    LayerPart part() const { return part_; }
    const Layer& before() const { return before_; }
    const std::shared_ptr<const Raster>& raster() const { return raster_; }  // before

    // Whether the layer is still there to be painted.
    bool stands_in(const Distribution& distribution) const;

    // The layer with another raster in this part, and a weight such that a facet that neither raster touches
    // stays as it is: see weigh_by_paint(). A layer whose last facet is hidden is left out until one shows
    // again.
    Layer with(std::shared_ptr<const Raster> raster) const;

  private:
    LayerPaint(std::size_t layer, LayerPart part, const Layer& given);
    double mass(const Raster& raster) const;
    double mass_max() const;  // of any raster

    std::size_t layer_;
    LayerPart part_;
    Layer before_;
    std::shared_ptr<const Raster> raster_;
    std::vector<double> facets_;  // under a mask: of each of its texels, in any unit
    double mass_ = 0, first_weight_ = 1;
};

// Adds a painted layer after the chosen one and chooses it; without effect where there is no room.
void add_painted_layer(Distribution& distribution, std::size_t& chosen);

}  // namespace nacre
