// A small disk that shows a layer's own part of p, the way up that it shines.
#pragma once

#include <imgui.h>

#include <vector>

#include "core/model/facet_distribution.h"

namespace nacre::ui {

class LayerThumbnails {
  public:
    // Looks at p again where its revision is another; null: no layer has a picture.
    void update(const FacetDistribution* p, int revision);

    // An empty disk for a layer that is left out of p.
    void draw(std::size_t layer, ImVec2 corner, float side) const;

  private:
    std::vector<std::vector<ImU32>> colours_;  // of each layer: the middle, then ring by ring
    int revision_ = -1;
};

}  // namespace nacre::ui
