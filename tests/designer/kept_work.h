// What a designer keeps for its user, below a folder of a test's own.
#pragma once

#include "core/paint/painted_layer.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

namespace nacre::test {

inline UserFolders below(const TemporaryFolder& folder) {
    return {.config = folder / "config/nacre",
            .state = folder / "state/nacre",
            .data = folder / "data/nacre",
            .home = folder.path()};
}

// With a layer whose raster takes some megabytes of a file.
inline Document painted_document() {
    Document document;
    Layer layer = blank_painted_layer();
    auto raster = std::make_shared<Raster>(*std::get<PaintedLobe>(layer.lobe).image.raster);
    for (std::size_t i = 0; i < raster->values.size(); ++i)
        raster->values[i] = static_cast<float>(i % 1000) * 0.001f;
    set_raster(layer, raster, 0, 1);
    document.design.distribution.layers.push_back(layer);
    document.commit();
    return document;
}

}  // namespace nacre::test
