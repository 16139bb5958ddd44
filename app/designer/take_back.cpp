#include "app/designer/take_back.h"

#include <imgui.h>

#include "app/designer/designer.h"
#include "ui/escape.h"
#include "ui/number_item.h"

namespace nacre {
namespace {

bool nothing_held(const Designer& designer) {
    return !ImGui::IsAnyItemActive() && !ui::slider_awaits_second_click() && !designer.remake.busy();
}

AtRest at_rest(const Designer& designer) {
    return {.scene = designer.scene,
            .camera = designer.canvas.state.camera,
            .layout = designer.settings.values.layout,
            .plots = designer.plots.state,
            .divider = designer.preview.look.divider,
            .layer = designer.layers.chosen};
}

void take_back(Designer& designer) {
    designer.document.design = designer.document.history.current();
    const AtRest& rest = designer.rest;
    designer.scene = rest.scene;
    designer.canvas.state.camera = rest.camera;
    designer.settings.values.layout = rest.layout;
    designer.plots.state = rest.plots;
    designer.preview.look.divider = rest.divider;
    designer.layers.chosen = rest.layer;
    designer.layers.remake.reset();
}

}  // namespace

void end_click(Designer& designer) {
    if (nothing_held(designer)) designer.document.commit();
}

void end_edit(Designer& designer) {
    ui::take_escape_of_drag();
    if (ui::drag_taken_back()) take_back(designer);
    if (!nothing_held(designer)) return;
    designer.document.commit();
    designer.rest = at_rest(designer);
}

}  // namespace nacre
