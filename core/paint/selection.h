// What of the sphere of normals the tools keep to.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/model/lobe_model.h"
#include "core/paint/disk_box.h"
#include "core/paint/hemisphere_view.h"

namespace nacre {

// Of each texel of a raster, how much it is selected, 0 to 1.
using TexelShares = std::vector<float>;

enum class SelectMode { replace, add, remove };

// In the surface's frame, so that it stays where it is seen whatever layer is painted. Never empty.
class Selection {
  public:
    // How much of a normal is selected, 0 to 1.
    double operator()(dvec3 h) const;

    // Closed lines around it on the equal-area disk; `below`: also where facets lie below the horizon.
    const std::vector<std::vector<dvec2>>& outlines(bool below) const { return below ? whole_ : upper_; }

    // Of the texels of a layer's raster with so many a side.
    std::shared_ptr<const TexelShares> texels(const glm::dmat3& layer_frame, int side) const;

  private:
    friend std::shared_ptr<const Selection> made(TexelShares amounts);
    friend std::shared_ptr<const Selection> select(const Selection*, SelectMode, const HemisphereView&,
                                                   std::span<const dvec2>);
    friend std::shared_ptr<const Selection> inverted(const Selection&);

    TexelShares amounts_;  // on the disk of the whole sphere, of radius sqrt(2)
    std::vector<std::vector<dvec2>> upper_, whole_;
};

// Each is null for a selection of nothing.
// What lies within an outline on the canvas, corners in pixels, with what was selected before, which is null
// where there was none.
std::shared_ptr<const Selection> select(const Selection* before, SelectMode mode, const HemisphereView& view,
                                        std::span<const dvec2> outline);
std::shared_ptr<const Selection> inverted(const Selection& selection);
std::shared_ptr<const Selection> select_all();

// Carried from one box of the disk to another.
std::shared_ptr<const Selection> carried(const Selection& selection, const DiskBox& from, const DiskBox& to);

}  // namespace nacre
