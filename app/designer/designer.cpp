#include "app/designer/designer.h"

#include <imgui.h>

#include <chrono>
#include <optional>
#include <utility>

#include "app/designer/scene_panel.h"
#include "app/designer/status.h"
#include "ui/item_map.h"
#include "ui/material_panel.h"
#include "ui/presets_panel.h"
#include "ui/status_line.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr double rest_seconds = 0.2;               // of a held button without a change of p
constexpr std::chrono::milliseconds patience{25};  // for a draft, while nothing else is drawn
constexpr double probe_radius = 3;                 // degrees of normals that glow while nothing is painted

void draw_presets(Designer& designer) {
    std::vector<std::string> names;
    std::optional<std::size_t> current;
    for (std::size_t i = 0; i < designer.presets.size(); ++i) {
        names.push_back(designer.presets[i].name);
        if (designer.presets[i].file == designer.document.preset) current = i;
    }
    if (const auto clicked = ui::presets_panel(names, current))
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
    tab("Light", [&] {
        designer.environment.rows(designer.scene.environment);
        scene_panel(designer.scene);
    });
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
    designer.objects.draw(designer.scene);
}

void draw_status(const Designer& designer) {
    ui::status_line({.tables = designer.tables_text,
                     .message = designer.files.message(),
                     .problem = designer.baker.problem(),
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

}  // namespace

Designer::Designer(int bake_threads) : baker(bake_threads), presets(list_presets(presets_folder())) {}

void draw_frame(Designer& designer) {
    Document& document = designer.document;
    if (!designer.files.talking() && !designer.pictures.talking() && !designer.objects.talking() &&
        !designer.environment.talking())
        if (const auto command = ui::pressed_shortcut()) perform(designer, *command);
    const ui::MenuState menu{.can_undo = document.history.can_undo(),
                             .can_redo = document.history.can_redo(),
                             .title = document.title()};
    if (const auto command = ui::menu_bar(menu)) perform(designer, *command);

    designer.canvas.state.marked = designer.preview.pointed_at();
    // The bake of what was painted runs while the canvas is drawn.
    const auto edited = [&] { ask(designer); };
    draw_layout(designer.layout,
                {.panel = [&] { draw_panel(designer); },
                 .canvas = [&] { designer.canvas.draw(document.design, designer.layers, edited); },
                 .preview =
                     [&] {
                         follow_bake(designer);
                         draw_preview(designer);
                     },
                 .status = [&] { draw_status(designer); }});
    designer.files.draw(document);
    if (!designer.files.talking())
        designer.pictures.draw(document.design.distribution, designer.layers.chosen, designer.canvas.state);
    if (!designer.files.talking() && !designer.pictures.talking()) designer.objects.talk();
    if (auto surroundings = designer.pictures.take_surroundings())
        designer.environment.want(surroundings->string());
    designer.environment.draw(designer.scene.environment);

    // One step of undo for each drag or typed text: it ends when nothing is held.
    if (!ImGui::IsAnyItemActive()) document.commit();
    ask(designer);
}

void take_file(Designer& designer, const std::filesystem::path& file) {
    if (names_object(file.string()))
        designer.objects.want(file.string());
    else
        designer.pictures.offer(file);
}

void perform(Designer& designer, ui::Command command) {
    Document& document = designer.document;
    switch (command) {
        case ui::Command::new_design:
            designer.files.start_new(document);
            break;
        case ui::Command::open:
            designer.files.start_open(document);
            break;
        case ui::Command::save:
            designer.files.save(document);
            break;
        case ui::Command::save_as:
            designer.files.save_as(document);
            break;
        case ui::Command::undo:
            document.undo();
            break;
        case ui::Command::redo:
            document.redo();
            break;
        case ui::Command::quit:
            designer.files.quit(document);
            break;
        case ui::Command::reset_camera:
            reset_camera(designer.scene);
            break;
    }
}

bool in_motion(const Designer& designer) {
    return designer.baker.busy() || designer.objects.busy() || designer.environment.busy() ||
           designer.preview.gathering();
}

}  // namespace nacre
