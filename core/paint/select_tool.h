// The tools that select: one file each, core/paint/selections/NAME.cpp, and its line in select_list.inc,
// which buttons, keys, their sheet and the manual follow.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/paint/tool_face.h"

namespace nacre {

enum class SelectTool {
#define SELECT(name) name,
#include "core/paint/select_list.inc"
#undef SELECT
};

struct SelectToolInfo {
    ToolFace face;
    // The corners of what the hand's way goes around, in pixels; the last is joined to the first.
    std::vector<glm::dvec2> (*outline)(std::span<const glm::dvec2> way);
};

const SelectToolInfo& info(SelectTool tool);

#define SELECT(name) extern const SelectToolInfo select_##name##_tool;
#include "core/paint/select_list.inc"
#undef SELECT

}  // namespace nacre
