// The brush's tools: one file each, core/paint/tools/NAME.cpp, and its line in tool_list.inc,
// which strokes, buttons, keys, their sheet and the manual follow.
#pragma once

#include <variant>

#include "core/paint/dab.h"
#include "core/paint/icon_pen.h"
#include "core/paint/shape.h"

namespace nacre {

enum class PaintTool {
#define TOOL(name) name,
#include "core/paint/tool_list.inc"
#undef TOOL
};

inline constexpr PaintTool paint_tools[] = {
#define TOOL(name) PaintTool::name,
#include "core/paint/tool_list.inc"
#undef TOOL
};

// How a tool is shown.
struct ToolFace {
    const char* name;
    char key;           // a letter
    const char* about;  // one line for tooltip, sheet and manual
    const char* more;   // for the tooltip alone
    void (*icon)(const IconPen& pen);
    bool begins_group = false;  // a gap before its button
};

// What it needs beside the brush's radius and flow.
enum class ToolNeed { hardness, picture, rays };

// A tool of dabs along the path of the hand. Full paint is 1, and values stay in [0, 1]. Copies of a
// symmetric dab that overlap count once, the strongest: a mirrored dab is exactly symmetric where the raster
// was and its side is a power of two; rotated ones are symmetric up to rounding. `scratch` is of the raster's
// side, and clear before and after.
struct DabTool {
    void (*dab)(Raster& raster, const Dab& dab, Coverage& scratch);
    bool at_press = true;     // else the first dab is along the path
    bool follows_way = true;  // else it is the press alone
};

struct PaintToolInfo {
    ToolFace face;
    ToolNeed needs = ToolNeed::hardness;
    std::variant<DabTool, ShapeDistance> work;
};

const PaintToolInfo& info(PaintTool tool);

#define TOOL(name) extern const PaintToolInfo name##_tool;
#include "core/paint/tool_list.inc"
#undef TOOL

}  // namespace nacre
