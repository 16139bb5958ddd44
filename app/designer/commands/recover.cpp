#include "app/designer/command.h"

namespace nacre {

const Command recover_command{
    .info = {.menu = "File",
             .label = "Recover unsaved work\u2026",
             .keys = nullptr,
             .about = "Work that was not saved when Nacre ended."},
    .enabled = [](const Designer& designer) { return !designer.options.folders.state.empty(); },
    .perform =
        [](Designer& designer, std::size_t) {
            designer.recovery.look();
            if (!designer.recovery.talking()) designer.files.tell("No unsaved work was left behind");
        }};

}  // namespace nacre
