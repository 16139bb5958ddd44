#include "app/designer/take_back.h"

#include <imgui.h>

#include "app/designer/designer.h"
#include "ui/canvas_transform.h"
#include "ui/escape.h"
#include "ui/focus.h"
#include "ui/number_item.h"

namespace nacre {
namespace {

bool nothing_held(const Designer& designer) {
    const ui::KeyboardFocus* const focus = ui::keyboard_focus();
    return !ImGui::IsAnyItemActive() && !ui::slider_awaits_second_click() &&
           !(focus && focus->is_changing()) && !designer.remake.busy();
}

// What is neither applied nor taken back is no step yet.
void commit(Designer& designer) {
    if (!ui::transform_pending(designer.canvas.state)) designer.document.commit();
}

// Whoever clicks beside the canvas goes on to something else: that is a step of its own.
void apply_for_click_elsewhere(Designer& designer) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !designer.canvas.holds(ImGui::GetIO().MousePos) &&
        !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        ui::apply_transform(designer.canvas.state);
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
    apply_for_click_elsewhere(designer);
    if (nothing_held(designer)) commit(designer);
}

void end_edit(Designer& designer) {
    ui::take_escape_of_drag();
    if (ui::drag_taken_back()) take_back(designer);
    if (!nothing_held(designer)) return;
    commit(designer);
    designer.rest = at_rest(designer);
}

}  // namespace nacre
