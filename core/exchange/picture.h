// Pictures of a lobe, read with OpenImageIO.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/design/design.h"
#include "core/light/lat_long.h"

namespace nacre {

enum class PictureShape {
    square,   // any other is an error
    any,      // as a Raster, one that is not square is letterboxed()
    lat_long  // twice as wide as high
};

// The luminance (Rec. 709) of a picture as a square raster, a larger one averaged down to limits::raster_max.
// Integer pictures are decoded from sRGB, so that the highlight looks like the picture; float ones
// are linear. Alpha multiplies: where the picture is transparent there are no facets.
// Whatever is wrong is a UserError of the design `error_file` at `error_where` that names the picture.
Raster load_picture(const std::filesystem::path& file, const std::string& error_file,
                    const std::string& error_where, PictureShape shape = PictureShape::square);

// Three numbers a pixel as they are stored, integers over their largest value, without regard to alpha; a
// grey is repeated. Upright, rows from the top. Of any shape.
struct ColourPicture {
    int width = 0, height = 0;
    std::vector<glm::vec3> colours;
    int channels = 3;     // of colour that the file has: 1 grey, 2 red and green with no blue (0 here), or 3
    bool encoded = true;  // integers in [0, 1]; else floats of any sign
};

// For pictures that are no looks but data, such as normals. A UserError of the picture itself.
ColourPicture load_colours(const std::filesystem::path& file);

// A surrounding by latitude and longitude, twice as wide as high; one that is wider than 2048 texels is
// averaged down. Float pictures are linear radiance, integers are decoded from sRGB. A UserError of the
// picture itself.
LatLong load_lat_long(const std::filesystem::path& file);

}  // namespace nacre
