#include "app/designer/command.h"
#include "app/designer/perform.h"

namespace nacre {

const Command system_dialogs_command{
    .info = {.menu = "File",
             .label = "Desktop's file dialogs",
             .keys = nullptr,
             .about = "Choose files in the desktop's own dialogs, or in Nacre's browser.",
             .begins_group = true},
    .enabled = [](const Designer& designer) { return designer.options.dialogs.has_value(); },
    .checked = [](const Designer& designer) { return file_dialogs(designer).has_value(); },
    .perform =
        [](Designer& designer, std::size_t) {
            bool& wanted = designer.settings.values.system_dialogs;
            wanted = !wanted;
        }};

}  // namespace nacre
