// The files that a design names.
#pragma once

#include <filesystem>
#include <vector>

#include "core/design/design.h"

namespace nacre {

// Of every picture that is a file, disabled layers included; each once.
std::vector<std::filesystem::path> picture_files(const Design& design);

// The pictures that painted layers were made from; each once. They are not needed to open the design.
std::vector<std::filesystem::path> source_files(const Design& design);

}  // namespace nacre
