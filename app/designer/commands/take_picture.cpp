#include "app/designer/command.h"

namespace nacre {

const Command take_picture_command{
    .info = {.menu = "File",
             .label = "Save preview image",
             .keys = "F12",
             .about = "Write the preview as a PNG file with the next free number; none is overwritten."},
    .perform = [](Designer& designer, std::size_t) { designer.pictures_of_preview.take(); }};

}  // namespace nacre
