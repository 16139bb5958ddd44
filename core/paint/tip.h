// A picture that is stamped, on the sphere of normals.
#pragma once

#include "core/paint/dab.h"

namespace nacre {

// The picture lies on the sphere about the dab, angles from its middle as lengths, turned as Dab::to_tip has
// it. Keeps a reference to the picture.
class Tip {
  public:
    explicit Tip(const Dab& dab);

    // How much it paints at a normal of the layer's frame, 0 to 1.
    double operator()(dvec3 h) const;

    // The normal under a point of the picture, which reaches from -1 to 1 each way.
    dvec3 direction(dvec2 at) const;

  private:
    const Raster& raster_;
    double radius_;
    glm::dmat3 from_pole_;
    glm::dmat2 to_tip_;
};

}  // namespace nacre
