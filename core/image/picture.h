// Pictures that are read. A cache keeps decoded pictures, so that the same content is decoded once.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/image/lat_long.h"
#include "core/image/raster.h"

namespace nacre {

// The extensions of the files that can be read, ".png" and so on, but for drawings (".svg").
const std::vector<std::string>& picture_extensions();

enum class PictureShape {
    square,  // any other is an error
    any      // one that is not square is letterboxed()
};

// The luminance (Rec. 709) of a picture as a square raster, upright, a larger one averaged down to
// limits::raster_max. Integers are decoded from sRGB where the file says nothing else, so that the highlight
// looks like the picture; floats are linear. Alpha multiplies once: where the picture is transparent there
// are no facets. Whatever is wrong is a UserError of the design `error_file` at `error_where` that names the
// picture.
Raster load_picture(const std::filesystem::path& file, const std::string& error_file,
                    const std::string& error_where, PictureShape shape = PictureShape::square,
                    PictureNotes* notes = nullptr);

// The same, held together with others who read a file of the same content.
std::shared_ptr<const Raster> load_shared_picture(const std::filesystem::path& file,
                                                  const std::string& error_file,
                                                  const std::string& error_where, PictureNotes& notes);

// What of a picture paints, as a stamp: its luminance as above, brought to a largest value of 1. Where the
// ground is white, or all that stands on a transparent ground is dark, as most logos have it, the dark paints
// instead, and a note says so. A UserError of the picture itself.
Raster load_stamp(const std::filesystem::path& file, PictureNotes* notes = nullptr);

// Three numbers a pixel as stored, integers over their largest value, not multiplied by alpha;
// grey is repeated. Upright, rows from the top, any shape.
struct ColourPicture {
    int width = 0, height = 0;
    std::vector<glm::vec3> colours;
    int channels = 3;     // of colour that the file has: 1 grey, 2 red and green with no blue (0 here), or 3
    bool encoded = true;  // integers in [0, 1]; else floats of any sign
    std::vector<float> alpha = {};  // a number a pixel; empty where the file has none
};

// For pictures that hold data, such as normals. A UserError of the picture itself.
ColourPicture load_colours(const std::filesystem::path& file, PictureNotes* notes = nullptr);

// A lat-long environment map: linear radiance of at most 2048 x 1024 texels, averaged down from
// at most 16384 x 8192 pixels. One that is not quite twice as wide as high is fitted, negative radiance
// counts as 0. A UserError of the picture itself.
LatLong load_lat_long(const std::filesystem::path& file, PictureNotes* notes = nullptr);

}  // namespace nacre
