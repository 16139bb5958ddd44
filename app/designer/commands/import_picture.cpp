#include "app/designer/command.h"
#include "app/designer/perform.h"

namespace nacre {

const Command import_picture_command{
    .info = {.menu = "File",
             .label = "Import picture\u2026",
             .keys = "Ctrl+I",
             .about = "Make a layer, a stamp, a modulation or an environment of a picture.",
             .begins_group = true},
    .perform = [](Designer& designer, std::size_t) {
        designer.pictures.ask(designer.files.folder(designer.document), file_dialogs(designer));
    }};

}  // namespace nacre
