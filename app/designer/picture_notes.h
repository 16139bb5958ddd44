// What is to be said of pictures that were read, as one line.
#pragma once

#include <filesystem>
#include <string>

#include "core/design/design.h"

namespace nacre {

// "a.png: one note; another"; empty without notes.
std::string notes_line(const std::filesystem::path& file, const PictureNotes& notes);

// Of all files that a design refers to, each once.
std::string notes_line(const Design& design);

}  // namespace nacre
