#include "app/designer/designer.h"

#include <imgui.h>

#include <chrono>
#include <optional>
#include <utility>

#include "app/designer/perform.h"
#include "app/designer/scene_panel.h"
#include "app/designer/status.h"
#include "ui/item_map.h"
#include "ui/material_panel.h"
#include "ui/presets_panel.h"
#include "ui/shortcut_sheet.h"
#include "ui/status_line.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr double rest_seconds = 0.2;               // of a held button without a change of p
constexpr std::chrono::milliseconds patience{25};  // for a draft, while nothing else is drawn
constexpr double probe_radius = 3;                 // degrees of normals that glow while nothing is painted

void draw_presets(Designer& designer) {
    designer.thumbnails.follow(designer.presets);
    std::vector<ui::PresetTile> tiles;
    std::optional<std::size_t> current;
    for (std::size_t i = 0; i < designer.presets.size(); ++i) {
        const Preset& preset = designer.presets[i];
        tiles.push_back({preset.name, designer.thumbnails.texture(preset.file)});
        if (preset.file == designer.document.preset) current = i;
    }
    if (const auto clicked = ui::presets_panel(tiles, current))
        designer.files.open_preset(designer.document, designer.presets[*clicked].file);
}

void draw_material(Design& design) {
    ui::text_field("Name##Design name", design.name, "Untitled", "The design's name.");
    ImGui::Spacing();
    ui::fresnel_panel(design.fresnel);
    ImGui::Spacing();
    ui::diffuse_panel(design.diffuse);
    ImGui::Spacing();
    ui::shadowing_panel(design.shadowing, design.distribution.mean_cosine_scale);
    ImGui::Spacing();
    ui::heading("Note");
    ui::note_field(design.note);
}

void draw_panel(Designer& designer) {
    Design& design = designer.document.design;
    if (!ImGui::BeginTabBar("tabs")) return;
    const auto tab = [](const char* label, const auto& contents) {
        const bool open = ImGui::BeginTabItem(label);
        ui::note_item(label);
        if (!open) return;
        ImGui::Spacing();
        contents();
        ImGui::EndTabItem();
    };
    designer.layers.thumbnails.update(designer.canvas.distribution(), designer.canvas.revision());
    tab("Layers", [&] { ui::layers_panel(designer.layers, design.distribution); });
    tab("Material", [&] { draw_material(design); });
    tab("Light", [&] { scene_panel(designer.scene); });
    tab("Presets", [&] { draw_presets(designer); });
    ImGui::EndTabBar();
}

// The tools of the canvas work on the sphere too, but for the handles: those leave the light to the pointer.
void draw_preview(Designer& designer) {
    ui::CanvasState& canvas = designer.canvas.state;
    const bool probing = canvas.tool == ui::CanvasTool::handles || canvas.tool == ui::CanvasTool::grab;
    const std::optional<dvec3>& there = designer.canvas.pointed_at();
    // The brush's mark must not hide what it paints.
    std::optional<dvec3> glow = there;
    if (!probing && !there) glow = designer.preview.pointed_at();
    if (!probing && ImGui::IsAnyMouseDown()) glow.reset();
    designer.preview.draw(designer.scene, glow, probing ? probe_radius : canvas.brush.radius,
                          [&](const ui::BrushSurface& sphere) {
                              return canvas.tool != ui::CanvasTool::handles &&
                                     ui::use_tool(canvas, sphere, designer.document.design.distribution,
                                                  designer.layers.chosen);
                          });
}

// What could not be kept: it stands before the last thing done.
std::string warning(const Designer& designer) {
    if (!designer.autosave.problem().empty())
        return "Unsaved work cannot be kept: " + designer.autosave.problem();
    if (!designer.settings.problem().empty()) return designer.settings.problem();
    return designer.recent.problem();
}

void draw_status(const Designer& designer) {
    ui::status_line({.tables = designer.tables_text,
                     .message = designer.files.message(),
                     .problem = designer.baker.problem(),
                     .warning = warning(designer),
                     .working = designer.baker.busy()});
}

// While p is dragged or painted a draft follows; what it rests on is baked to the end.
void notice_rest(Designer& designer, const Distribution& shown) {
    const double now = ImGui::GetTime();
    if (shown != designer.last_shown) {
        designer.last_shown = shown;
        designer.changed_at = now;
    }
    designer.settled = !ImGui::IsAnyMouseDown() || now - designer.changed_at > rest_seconds;
}

// Asks for tables of what is shown now.
void ask(Designer& designer) {
    Design shown = designer.document.design;
    shown.distribution = ui::shown(designer.layers, shown.distribution);
    notice_rest(designer, shown.distribution);
    designer.baker.want(
        {.design = std::move(shown), .albedo = designer.scene.ambient, .settled = designer.settled});
}

// A draft that comes within a moment is seen in the very frame of the edit that it answers.
void follow_bake(Designer& designer) {
    if (auto tables = designer.baker.poll(patience)) {
        designer.tables_text = tables_text(*tables);
        designer.preview.show(std::move(tables));
    }
}

std::filesystem::path autosave_folder(const UserFolders& folders) {
    return folders.state.empty() ? folders.state : folders.state / "unsaved";
}

void prepare_dialogs(Designer& designer) {
    const auto dialogs = file_dialogs(designer);
    designer.files.remember({.settings = &designer.settings.values,
                             .recent = &designer.recent,
                             .dialogs = dialogs,
                             .home = designer.options.folders.home});
    designer.exporter.remember(&designer.settings.values, dialogs);
    designer.pictures_of_preview.remember(&designer.settings.values, dialogs);
}

void tell(Designer& designer, const std::optional<std::string>& message) {
    if (message) designer.files.tell(*message);
}

// One at a time.
void draw_dialogs(Designer& designer) {
    Document& document = designer.document;
    designer.files.draw(document);
    if (auto restored = designer.files.take_restored()) designer.autosave.take_over(std::move(*restored));
    if (designer.files.talking()) return;
    if (auto found = designer.recovery.draw())
        designer.files.restore(document, std::move(*found));
    else if (designer.sheet)
        designer.sheet = ui::shortcut_sheet();
    else if (designer.exporter.talking())
        tell(designer, designer.exporter.draw(document, designer.preview, designer.scene));
    else if (designer.pictures_of_preview.talking() || designer.pictures_of_preview.in_motion())
        tell(designer, designer.pictures_of_preview.draw(document, designer.preview, designer.scene));
    else
        designer.pictures.draw(document.design.distribution, designer.layers.chosen, designer.canvas.state);
}

// On the disk: the newest step of undo at once, the settings while no border is dragged.
void keep(Designer& designer) {
    designer.autosave.follow(designer.document);
    if (!ImGui::IsAnyMouseDown()) designer.settings.keep();
}

}  // namespace

Designer::Designer(const DesignerOptions& given)
    : options(given),
      settings(options.folders.config),
      recent(options.folders.state),
      autosave(autosave_folder(options.folders)),
      recovery(autosave_folder(options.folders)),
      baker(options.bake_threads),
      presets(list_presets(presets_folder())) {
    if (!options.folders.data.empty())
        for (Preset& own : list_presets(options.folders.data / "presets")) presets.push_back(std::move(own));
    recovery.look();
}

bool talking(const Designer& designer) {
    return designer.files.talking() || designer.pictures.talking() || designer.recovery.talking() ||
           designer.exporter.talking() || designer.pictures_of_preview.talking() || designer.sheet;
}

void draw_frame(Designer& designer) {
    Document& document = designer.document;
    prepare_dialogs(designer);
    if (!talking(designer))
        if (const auto order = ui::pressed_shortcut()) perform(designer, *order);
    if (const auto order = ui::menu_bar(menu_state(designer))) perform(designer, *order);

    designer.canvas.state.marked = designer.preview.pointed_at();
    // The bake of what was painted runs while the canvas is drawn.
    const auto edited = [&] { ask(designer); };
    Parts parts{.panel = [&] { draw_panel(designer); },
                .canvas = [&] { designer.canvas.draw(document.design, designer.layers, edited); },
                .preview =
                    [&] {
                        follow_bake(designer);
                        draw_preview(designer);
                    },
                .status = [&] { draw_status(designer); }};
    if (!designer.panels) parts.panel = nullptr;
    draw_layout(designer.settings.values.layout, parts);
    draw_dialogs(designer);

    // One step of undo for each drag or typed text: it ends when nothing is held.
    if (!ImGui::IsAnyItemActive()) document.commit();
    ask(designer);
    keep(designer);
    ui::reserve_tab();
}

bool in_motion(const Designer& designer) {
    return designer.baker.busy() || designer.files.has_answer() || designer.exporter.in_motion() ||
           designer.pictures_of_preview.in_motion() || designer.thumbnails.busy();
}

void finish(Designer& designer) {
    designer.settings.keep();
    designer.autosave.finish();
}

}  // namespace nacre
