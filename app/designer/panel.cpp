#include "app/designer/panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/designer/command.h"
#include "app/designer/perform.h"
#include "app/designer/scene_panel.h"
#include "core/base/limits.h"
#include "core/design/design_check.h"
#include "ui/item_map.h"
#include "ui/material_panel.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

// A metal that is new begins with the light that bounces between its facets, which makes rough ones as bright
// as they are.
void draw_fresnel(Design& design) {
    const bool was_metal = is_metal(design.fresnel);
    ui::fresnel_panel(design.fresnel);
    const bool alone = std::holds_alternative<NoDiffuse>(design.diffuse) && bounce_problem(design).empty();
    if (!was_metal && is_metal(design.fresnel) && alone) design.multibounce = MomentumMultibounce{};
}

// What rules bounces out ends them.
void draw_bounces(Design& design) {
    const std::string problem = bounce_problem(design);
    if (!problem.empty()) design.multibounce = NoMultibounce{};
    ImGui::BeginDisabled(!problem.empty());
    ui::multibounce_panel(design.multibounce);
    ImGui::EndDisabled();
    if (!problem.empty()) ui::dim_text(fmt::format("None: {}.", problem));
}

void draw_material(Design& design) {
    ui::text_field("Name##Design name", design.name, "Untitled",
                   "The design's name: it appears in the window's title, in exported tables and in GLSL.");
    ImGui::Spacing();
    draw_fresnel(design);
    ImGui::Spacing();
    ui::diffuse_panel(design.diffuse);
    ImGui::Spacing();
    draw_bounces(design);
    ImGui::Spacing();
    ui::shadowing_panel(design.shadowing, design.distribution.mean_cosine_scale);
    ImGui::Spacing();
    ui::retro_panel(design.retro);
    ImGui::Spacing();
    ui::coat_panel(design.coat);
    ImGui::Spacing();
    ui::heading("Note");
    ui::note_field(design.note);
}

// How bright the whole highlight is, whatever its layers are.
void draw_intensity(Specular& specular) {
    ui::slider(
        {.label = "Intensity",
         .low = 0,
         .high = 2,
         .least = 0,
         .most = limits::intensity_max,
         .reset = Specular().intensity,
         .format = "%.2f",
         .logarithmic = false,
         .tooltip = "How bright the whole highlight is: a factor on the specular term, applied last. Above 1 "
                    "it reflects more light than falls on it."},
        specular.intensity);
    if (specular.intensity > 1) ui::warning_text("Creates energy: it reflects more than it gets.");
    ImGui::Spacing();
}

// What the menu of the list has asked for.
void use_clipboard(Designer& designer) {
    const auto asked = std::exchange(designer.layers.asked, std::nullopt);
    if (asked == ui::ClipboardAction::cut) perform(designer, cut_layer_command);
    if (asked == ui::ClipboardAction::copy) perform(designer, copy_layer_command);
    if (asked == ui::ClipboardAction::paste) perform(designer, paste_layer_command);
}

// Final tables of this design, if they are what the preview shows.
std::shared_ptr<const Tables> final_tables(const Designer& designer) {
    const bool newest = designer.baker.answered() == designer.baker.asked();
    const auto& tables = designer.frame.tables;
    return newest && tables && tables->quality == Quality::final ? tables : nullptr;
}

void draw_compare(Designer& designer) {
    Design& design = designer.document.design;
    const bool whole = designer.frame.design == design;
    const PresentDesign present{design, whole ? final_tables(designer) : nullptr, designer.frame.settled};
    if (auto restored = designer.comparison.draw_panel(present, designer.scene, designer.preview))
        design = *std::move(restored);
}

}  // namespace

void draw_panel(Designer& designer) {
    Design& design = designer.document.design;
    // So that no tab's name is cut.
    const ImVec2 padding = ImGui::GetStyle().FramePadding, narrow(padding.x * 0.5f, padding.y);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, narrow);
    const bool bar = ImGui::BeginTabBar("tabs");
    ImGui::PopStyleVar();
    if (!bar) return;
    const auto tab = [narrow, &designer](const char* label, const auto& contents) {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, narrow);
        const bool wanted = designer.open_tab != nullptr && std::string_view(designer.open_tab) == label;
        const bool open = ImGui::BeginTabItem(
            label, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
        if (wanted) designer.open_tab = nullptr;
        ImGui::PopStyleVar();
        ui::note_item(label);
        if (!open) return;
        ImGui::Spacing();
        contents();
        ImGui::EndTabItem();
    };
    designer.layers.thumbnails.update(designer.frame.p.get(), designer.frame.revision);
    tab("Layers", [&] {
        draw_intensity(design.specular);
        ui::CanvasState& canvas = designer.canvas.state;
        const bool painted = canvas.paints_mask;
        ui::layers_panel(designer.layers, design.distribution, canvas.paints_mask);
        if (canvas.paints_mask && !painted && canvas.tool == ui::CanvasTool::handles)
            canvas.tool = ui::CanvasTool::erase;
        use_clipboard(designer);
    });
    tab("Material", [&] { draw_material(design); });
    tab("Light", [&] {
        designer.environment.rows(designer.scene.environment, file_dialogs(designer));
        scene_panel(designer.scene);
    });
    tab("Compare", [&] { draw_compare(designer); });
    tab("Presets", [&] { draw_presets(designer); });
    ImGui::EndTabBar();
}

}  // namespace nacre
