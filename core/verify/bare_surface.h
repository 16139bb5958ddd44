// A design with its material and layers made ready for shading, and no tables.
#pragma once

#include <vector>

#include "core/shading/surface.h"

namespace nacre {

struct BareSurface {
    // Throws UserError like bake().
    explicit BareSurface(const Design& design) : distribution(design.distribution) {
        describe_material(design, distribution, shading);
        describe_layers(design.distribution, distribution, shading, data);
        shading.data = data.data();
    }
    BareSurface(const BareSurface&) = delete;
    BareSurface& operator=(const BareSurface&) = delete;

    FacetDistribution distribution;
    Shading<double> shading;

  private:
    std::vector<float> data;
};

}  // namespace nacre
