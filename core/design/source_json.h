// `source` of a layer in the design file: how its raster was made from a picture.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/json_reader.h"
#include "core/model/picture_source.h"

namespace nacre {

// The picture's path is relative to `base_dir`. The picture is not read.
PictureSource read_source(const JsonValue& json, const std::filesystem::path& base_dir);

// As JSON; `image` is the picture's path as JSON text. What is at its default is left out.
std::string source_text(const PictureSource& source, const std::string& image);

}  // namespace nacre
