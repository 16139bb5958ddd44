#include "app/designer/command.h"
#include "ui/canvas_paint.h"
#include "ui/canvas_tools.h"

namespace nacre {
namespace {

// Not of a layer that has nothing painted.
bool can_clear(const Designer& designer) {
    const ui::CanvasState& canvas = designer.canvas.state;
    const Distribution& distribution = designer.document.design.distribution;
    const std::size_t chosen = designer.layers.chosen;
    return canvas.selection != nullptr && chosen < distribution.layers.size() &&
           has_part(distribution.layers[chosen], ui::part_in_hand(canvas, distribution, chosen));
}

}  // namespace

const Command clear_selection_command{
    .info = {.menu = "Select",
             .label = "Clear selection",
             .keys = "Delete",
             .about = "Erase what is selected of the layer's paint, or of its mask."},
    .enabled = can_clear,
    .perform = [](Designer& designer, std::size_t) {
        ui::paint_selection(designer.canvas.state, {.value = 0}, designer.document.design.distribution,
                            designer.layers.chosen);
    }};

}  // namespace nacre
