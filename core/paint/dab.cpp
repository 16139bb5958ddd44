#include "core/paint/dab.h"

namespace nacre {

void cover(const Raster& raster, const Dab& dab, Coverage& coverage) {
    visit_covered(raster, dab,
                  [&](const SeenTexel& texel, double amount) { coverage.add(texel.index, amount); });
}

}  // namespace nacre
