// What is selected of a raster, carried, turned and stretched by a box.
#pragma once

#include <memory>
#include <optional>

#include "core/image/raster.h"
#include "core/paint/brush.h"
#include "core/paint/disk_box.h"
#include "core/paint/selection.h"

namespace nacre {

class Transform {
  public:
    // `selected`: of the raster's texels, null for all; the frame is the layer's, and the box lies on the
    // surface's disk. Nothing where there is nothing to carry.
    static std::optional<Transform> of(std::shared_ptr<const Raster> before, const glm::dmat3& layer_frame,
                                       const std::shared_ptr<const TexelShares>& selected);

    const DiskBox& box() const { return box_; }  // about what is carried, where it lies

    // The raster with what is selected taken from its place to that box, combined there with what is left;
    // read between texels, so that nothing has holes. What leaves the disk is lost.
    std::shared_ptr<const Raster> carried(const DiskBox& to, Blend blend) const;

  private:
    Transform() = default;

    std::shared_ptr<const Raster> before_;
    std::vector<float> shares_, part_, rest_;  // part_ is before_ by its share
    glm::dmat3 frame_{1};
    std::vector<dvec2> places_;  // of the texels on the surface's disk
    DiskBox box_;
};

}  // namespace nacre
