// One layer of the design file.
#pragma once

#include <filesystem>

#include "core/base/json_reader.h"
#include "core/design/design.h"

namespace nacre {

// Pictures are looked for relative to `base_dir`, which is absolute, and are read.
Layer read_layer(const JsonValue& json, const std::filesystem::path& base_dir);

}  // namespace nacre
