#include <utility>

#include "app/designer/command.h"

namespace nacre {
namespace {

// Erase, and back to the tool that it was taken for.
void toggle_erase(Designer& designer, std::size_t) {
    ui::CanvasTool& tool = designer.canvas.state.tool;
    if (tool == ui::CanvasTool::erase) {
        tool = std::exchange(designer.tool_before_erase, std::nullopt).value_or(ui::CanvasTool::paint);
    } else {
        designer.tool_before_erase = tool;
        tool = ui::CanvasTool::erase;
    }
}

}  // namespace

const Command erase_command{
    .info = {.menu = "Canvas", .label = nullptr, .keys = "X", .about = "Erase, and back to the tool before."},
    .perform = toggle_erase};

}  // namespace nacre
