#include <optional>
#include <utility>

#include "app/designer/command.h"
#include "ui/canvas_transform.h"

namespace nacre {

const Command undo_command{
    .info = {.menu = "Edit",
             .label = "Undo",
             .keys = "Ctrl+Z",
             .about = "Take back a stroke or a drag.",
             .repeats = true},
    .enabled =
        [](const Designer& designer) {
            return designer.document.history.can_undo() || ui::transform_pending(designer.canvas.state);
        },
    .perform =
        [](Designer& designer, std::size_t) {
            if (std::exchange(designer.layers.remake, std::nullopt))  // an edit that has not ended
                designer.document.design = designer.document.history.current();
            else
                designer.document.undo();
        }};

}  // namespace nacre
