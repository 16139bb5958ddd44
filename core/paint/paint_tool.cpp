#include "core/paint/paint_tool.h"

#include <array>

namespace nacre {

const PaintToolInfo& info(PaintTool tool) {
    static constexpr std::array list{
#define TOOL(name) &name##_tool,
#include "core/paint/tool_list.inc"
#undef TOOL
    };
    return *list[static_cast<std::size_t>(tool)];
}

bool is_as_wide_as_brush(const PaintToolInfo& tool) {
    return std::holds_alternative<DabTool>(tool.work) || std::holds_alternative<ShapeDistance>(tool.work);
}

}  // namespace nacre
