#include "app/designer/command.h"

namespace nacre {

const Command picture_folder_command{
    .info = {.menu = "File",
             .label = "Screenshot folder\u2026",
             .keys = nullptr,
             .about = "Choose where F12 writes its pictures."},
    .perform = [](Designer& designer, std::size_t) { designer.pictures_of_preview.choose_folder(); }};

}  // namespace nacre
