// The brush's tools: one file each, core/paint/tools/NAME.cpp, and its line in tool_list.inc,
// which strokes, buttons, keys, their sheet and the manual follow.
#pragma once

#include <variant>

#include "core/paint/dab.h"
#include "core/paint/selection.h"
#include "core/paint/shape.h"
#include "core/paint/tool_face.h"

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

// What it needs beside the brush's radius and flow, or, of a tool that has no use for those, beside its value
// and opacity.
enum class ToolNeed { hardness, picture, rays, tolerance, form };

// A tool of dabs along the path of the hand. Full paint is 1, and values stay in [0, 1]. Copies of a
// symmetric dab that overlap count once, the strongest: a mirrored dab is exactly symmetric where the raster
// was and its side is a power of two; rotated ones are symmetric up to rounding. `scratch` is of the raster's
// side, and clear before and after.
struct DabTool {
    void (*dab)(Raster& raster, const Dab& dab, Coverage& scratch);
    bool at_press = true;     // else the first dab is along the path
    bool follows_way = true;  // else it is the press alone
};

// What a press points at.
struct PressedArea {
    BrushSymmetry symmetry;
    dvec3 at{0, 0, 1};
    double tolerance;                       // between values that count as like
    const TexelShares* selected = nullptr;  // null: all
};

// Covers at once what belongs to the press by what is there.
struct AreaTool {
    void (*cover)(const Raster& raster, const PressedArea& area, Coverage& coverage);
};

struct PaintToolInfo {
    ToolFace face;
    ToolNeed needs = ToolNeed::hardness;
    std::variant<DabTool, ShapeDistance, GradientTool, AreaTool> work;
};

// Whether the brush's radius, hardness and flow play a part.
bool is_as_wide_as_brush(const PaintToolInfo& tool);

const PaintToolInfo& info(PaintTool tool);

#define TOOL(name) extern const PaintToolInfo name##_tool;
#include "core/paint/tool_list.inc"
#undef TOOL

}  // namespace nacre
