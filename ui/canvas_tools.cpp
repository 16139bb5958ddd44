#include "ui/canvas_tools.h"

#include <imgui.h>

#include "ui/edit_name.h"

namespace nacre::ui {
namespace {

constexpr ToolFace handles_face{.name = "Handles",
                                .key = 'V',
                                .about = "Shapes lobes by their handles.",
                                .more = "The middle tilts a lobe, its ends widen it, its outline turns it.",
                                .icon = [](const IconPen& pen) {
                                    pen.fill({{0.30f, 0.15f}, {0.30f, 0.72f}, {0.46f, 0.58f}});
                                    pen.fill({{0.30f, 0.15f}, {0.46f, 0.58f}, {0.72f, 0.56f}});
                                    pen.line({{0.44f, 0.54f}, {0.57f, 0.84f}});
                                }};

constexpr ToolFace grab_face{
    .name = "Grab",
    .key = 'G',
    .about = "Carries a highlight along, here or on the object.",
    .more =
        "Of the layer that is strongest there a painted hill follows up to the valleys about it, a lobe "
        "as a whole.",
    .icon = [](const IconPen& pen) {
        pen.line({{0.5f, 0.14f}, {0.5f, 0.86f}});
        pen.line({{0.14f, 0.5f}, {0.86f, 0.5f}});
        pen.line({{0.40f, 0.24f}, {0.5f, 0.13f}, {0.60f, 0.24f}});
        pen.line({{0.40f, 0.76f}, {0.5f, 0.87f}, {0.60f, 0.76f}});
        pen.line({{0.24f, 0.40f}, {0.13f, 0.5f}, {0.24f, 0.60f}});
        pen.line({{0.76f, 0.40f}, {0.87f, 0.5f}, {0.76f, 0.60f}});
    }};

constexpr ToolFace transform_face{
    .name = "Transform",
    .key = 'C',
    .about = "Carries, turns and stretches what is selected, or all paint.",
    .more =
        "By a box of handles, combined as the list says. Enter or a click outside applies, Escape takes it "
        "back.",
    .icon = [](const IconPen& pen) {
        pen.line({{0.24f, 0.24f}, {0.76f, 0.24f}, {0.76f, 0.76f}, {0.24f, 0.76f}}, true);
        for (const float x : {0.24f, 0.76f})
            for (const float y : {0.24f, 0.76f}) pen.disc({x, y}, 0.10f);
    }};

constexpr ToolEntry tools[] = {
    {CanvasTool::handles, &handles_face},
    {CanvasTool::grab, &grab_face},
#define TOOL(name) {CanvasTool::name, &name##_tool.face, PaintTool::name},
#include "core/paint/tool_list.inc"
#undef TOOL
#define SELECT(name) {CanvasTool::select_##name, &select_##name##_tool.face, {}, SelectTool::name},
#include "core/paint/select_list.inc"
#undef SELECT
    {CanvasTool::transform, &transform_face},
};

}  // namespace

std::span<const ToolEntry> canvas_tools() { return tools; }

std::string tool_tooltip(const ToolFace& face) {
    return std::string(face.name) + " (" + face.key + "). " + face.about + " " + face.more;
}

void name_edit_by_tool(CanvasTool tool) {
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseReleased(ImGuiMouseButton_Left))
        name_edit(tools[static_cast<std::size_t>(tool)].face->name);
}

std::optional<PaintTool> paints_with(CanvasTool tool) { return tools[static_cast<std::size_t>(tool)].paints; }

std::optional<SelectTool> selects_with(CanvasTool tool) {
    return tools[static_cast<std::size_t>(tool)].selects;
}

bool works_on_object(CanvasTool tool) { return tool == CanvasTool::grab || paints_with(tool); }

LayerPart part_in_hand(const CanvasState& state, const Distribution& distribution, std::size_t chosen) {
    const auto& layers = distribution.layers;
    const bool masked = chosen < layers.size() && has_part(layers[chosen], LayerPart::mask);
    return state.paints_mask && masked ? LayerPart::mask : LayerPart::lobe;
}

}  // namespace nacre::ui
