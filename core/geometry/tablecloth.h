// The tablecloth of the preview: a square cloth draped over a round table.
#pragma once

#include "core/geometry/cloth.h"
#include "core/geometry/mesh.h"

namespace nacre {

// How the cloth hangs once it has come to rest. Takes about a second; the same bits in every run.
Cloth draped_cloth(const RoundTable& table = {});

// The smooth surface whose control points the cloth's are, scaled as fit() does. Tangents run along the warp.
Mesh cloth_mesh(const Cloth& cloth);

}  // namespace nacre
