#pragma once

#include <string>

#include "core/image/raster.h"

namespace nacre::ui {

// "in the design, 256 x 256", or the file's name in place of the first part.
std::string picture_text(const Picture& picture);

// With what is to be said of it below.
void picture_row(const char* label, const Picture& picture);

}  // namespace nacre::ui
