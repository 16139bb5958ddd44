#include "app/designer/take_up.h"

#include <algorithm>

#include "app/designer/designer.h"
#include "ui/canvas_tools.h"

namespace nacre {
namespace {

bool is_built_in(const std::string& name) {
    const auto kinds = object_kinds();
    return std::any_of(kinds.begin(), kinds.end(),
                       [&](const ObjectKind* kind) { return kind->name == name; });
}

}  // namespace

Habits habits_of(const Designer& designer) {
    const ui::CanvasState& canvas = designer.canvas.state;
    const Scene& scene = designer.scene;
    Habits habits{.tool = ui::canvas_tools()[static_cast<std::size_t>(canvas.tool)].face->name,
                  .brush = canvas.brush,
                  .steadiness = canvas.steadiness,
                  .own_brushes = canvas.own_brushes,
                  .tolerance = canvas.tolerance,
                  .form = canvas.form,
                  .scale = canvas.scale,
                  .highlight = canvas.camera.highlight,
                  .expert = designer.layers.expert,
                  .has_dragged = !designer.hints_to_drag,
                  .has_painted = !designer.hints_to_paint,
                  .yaw = scene.yaw,
                  .pitch = scene.pitch,
                  .zoom = scene.zoom};
    if (is_built_in(scene.object.name)) habits.object = scene.object.name;
    return habits;
}

void take_up(Designer& designer, const Habits& habits) {
    ui::CanvasState& canvas = designer.canvas.state;
    for (const ui::ToolEntry& entry : ui::canvas_tools())
        if (habits.tool == entry.face->name) canvas.tool = entry.tool;
    canvas.brush = habits.brush;
    canvas.steadiness = habits.steadiness;
    canvas.own_brushes = habits.own_brushes;
    canvas.tolerance = habits.tolerance;
    canvas.form = habits.form;
    canvas.scale = habits.scale;
    canvas.camera.highlight = habits.highlight;
    designer.layers.expert = habits.expert;
    designer.hints_to_drag = !habits.has_dragged;
    designer.hints_to_paint = !habits.has_painted;
    if (is_built_in(habits.object) && habits.object != designer.scene.object.name)
        designer.objects.want(habits.object, true);
    designer.scene.yaw = habits.yaw;
    designer.scene.pitch = habits.pitch;
    designer.scene.zoom = habits.zoom;
}

}  // namespace nacre
