#pragma once

#include "core/pictures/exr_header.h"

namespace nacre {

// A PictureProblem where a block of pixels of the first part is missing, is cut short or holds
// too few pixels: the decoder would show uninitialised memory. Also where memory for one is more than the
// file can fill.
void check_exr_blocks(const FileBytes& file, const ExrHeaders& headers);

}  // namespace nacre
