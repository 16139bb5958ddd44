// Reading and writing of pictures as a shared library, loaded on demand: OpenImageIO brings two hundred
// others that take longer to load than the rest of the program, and most runs use no picture.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/image/image_file.h"
#include "core/image/picture.h"

namespace nacre {

// The functions of core/image/picture.h, clear_part.h and image_file.h that need OpenImageIO.
struct PictureModule {
    const char* version;  // of Nacre; first, and the same in all: the program may be of another
    Raster (*load_picture)(const std::filesystem::path&, const std::string&, const std::string&, PictureShape,
                           PictureNotes*);
    Raster (*load_stamp)(const std::filesystem::path&, PictureNotes*);
    ColourPicture (*load_colours)(const std::filesystem::path&, PictureNotes*);
    double (*load_clear_part)(const std::filesystem::path&);
    LatLong (*load_lat_long)(const std::filesystem::path&, PictureNotes*);
    ImageBytes (*png_bytes)(glm::ivec2, std::span<const std::uint8_t>);
    ImageBytes (*exr_bytes)(glm::ivec2, const std::vector<std::string>&, std::span<const float>);
};

}  // namespace nacre

// The one symbol that the library exports.
extern "C" const nacre::PictureModule* nacre_picture_module();
