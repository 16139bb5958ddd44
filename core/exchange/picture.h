// Pictures of a lobe, read with OpenImageIO.
#pragma once

#include <filesystem>
#include <string>

#include "core/design/design.h"

namespace nacre {

// The luminance (Rec. 709) of a square picture, a larger one averaged down to limits::raster_max.
// Integer pictures are decoded from sRGB, so that the highlight looks like the picture; float ones
// are linear. Alpha multiplies: where the picture is transparent there are no facets.
// Whatever is wrong is a UserError of the design `error_file` at `error_where` that names the picture.
Raster load_picture(const std::filesystem::path& file, const std::string& error_file,
                    const std::string& error_where);

}  // namespace nacre
