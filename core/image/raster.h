// Pictures of the hemisphere of facet normals, as a painted lobe or a modulation holds them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace nacre {

// A grey picture of the hemisphere seen from above: an equal-area (Lambert azimuthal) disk that
// touches the four sides, +x right, +y up. Row-major, top row first, finite values >= 0.
struct Raster {
    int width = 0;  // pixels; equal to height, at least 1
    int height = 0;
    std::vector<float> values;

    bool operator==(const Raster&) const = default;
};

// Remarks on a picture that was read: a part that is not used, a size that was
// changed. One sentence each, without the file.
using PictureNotes = std::vector<std::string>;

// A raster held in the design, or a picture file beside it. `file` is absolute and empty
// when the raster is held in the design. `raster` is never null in a loaded design.
struct Picture {
    std::filesystem::path file;
    std::shared_ptr<const Raster> raster;
    PictureNotes notes = {};  // of the file that was read; no part of the design

    bool operator==(const Picture& other) const;
};

// Whether no pixel is above 0, so that the picture holds no facets.
bool is_black(const Picture& picture);

}  // namespace nacre
