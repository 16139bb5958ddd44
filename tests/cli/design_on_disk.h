#pragma once

#include <string>

#include "core/design/design.h"
#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"

namespace nacre::test {

// A design as a file of its own.
class DesignOnDisk {
  public:
    explicit DesignOnDisk(const Design& design) { save_design(design, folder_ / "design.nacre"); }

    std::string path() const { return (folder_ / "design.nacre").string(); }

  private:
    TemporaryFolder folder_;
};

inline Layer layer_of(const Lobe& lobe) {
    Layer layer;
    layer.lobe = lobe;
    return layer;
}

// One layer, F = 1 and no diffuse term.
inline Design design_of(const Lobe& lobe) {
    Design design;
    design.name = "test";
    design.distribution.layers = {layer_of(lobe)};
    design.fresnel = NoFresnel{};
    return design;
}

// The paper's slanted velvet: a cylinder tilted by 40 degrees, N doubled (Ashikhmin 2000, sec. 6.4).
inline Design slanted_velvet(bool clamp) {
    Design design = design_of(GaussianLobe{.sigma_x = 0.5, .sigma_y = limits::infinity});
    design.distribution.layers[0].tilt = 40;
    design.distribution.mean_cosine_scale = 2;
    design.shadowing.clamp = clamp;
    return design;
}

}  // namespace nacre::test
