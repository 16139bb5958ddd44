#include "app/designer/designer.h"

#include <imgui.h>

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "app/designer/command.h"
#include "app/designer/dialogs_in_turn.h"
#include "app/designer/other_side.h"
#include "app/designer/panel.h"
#include "app/designer/past.h"
#include "app/designer/perform.h"
#include "app/designer/status.h"
#include "app/designer/take_back.h"
#include "app/designer/take_up.h"
#include "app/designer/work_files.h"
#include "core/base/error.h"
#include "ui/abandon_frame.h"
#include "ui/brush_mark.h"
#include "ui/canvas_tools.h"
#include "ui/edit_name.h"
#include "ui/escape.h"
#include "ui/status_line.h"
#include "ui/term_bar.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr double rest_seconds = 0.2;                      // of a held button without a change of p
constexpr std::chrono::milliseconds patience{25};         // for a draft, while nothing else is drawn
constexpr std::chrono::milliseconds first_patience{500};  // frames without a picture would only delay it
constexpr double probe_radius = 3;  // degrees of normals that glow while nothing is painted

Design shown_design(const Designer& designer) {
    if (designer.trial) return designer.trial->design;
    Design shown = designer.document.design;
    shown.distribution = ui::shown(designer.layers, shown.distribution);
    return shown;
}

// The tools of the canvas work on the sphere too, but for the handles: those leave the light to the pointer.
void work_on_preview(Designer& designer) {
    Scene& scene = designer.scene;
    const bool shows_model = designer.comparison.shows_model();
    if (shows_model && is_factor(scene.term)) scene.term = Term::total;
    designer.objects.draw(scene, file_dialogs(designer));
    if (const auto note = designer.objects.take_note()) designer.files.tell(*note);
    const auto& tables = designer.frame.tables;
    ui::term_bar(scene.term, tables ? tables->shading.kinds : ShadingKinds{}, !shows_model,
                 designer.layers.expert);
    ui::CanvasState& canvas = designer.canvas.state;
    const auto sphere = designer.preview.point(scene);
    const bool taken = sphere && ui::works_on_object(canvas.tool) &&
                       ui::use_tool(canvas, *sphere, designer.frame.p.get(),
                                    designer.document.design.distribution, designer.layers.chosen);
    if (taken) ui::name_edit_by_tool(canvas.tool);
    designer.preview.work(scene, taken);
}

// What to do first, until it is done.
void follow_hints(Designer& designer) {
    if (designer.scene.light != Scene().light) designer.hints_to_drag = false;
    if (designer.canvas.state.last_stroke) designer.hints_to_paint = false;
}

void draw_preview(Designer& designer) {
    const Frame& frame = designer.frame;
    designer.comparison.follow({frame.design, nullptr, frame.settled}, designer.scene, designer.preview);
    const ui::CanvasState& canvas = designer.canvas.state;
    const std::optional<dvec3>& there = designer.canvas.pointed_at();
    Veil veil;
    if (!ui::paints_with(canvas.tool)) {
        if (there) veil = spot(*there, probe_radius);
    } else if (!ImGui::IsAnyMouseDown()) {  // the brush's mark must not hide what it paints
        if (const auto at = there ? there : designer.preview.pointed_at())
            veil.strength = ui::brush_veil(canvas, frame.design.distribution, designer.layers.chosen, *at);
    }
    designer.preview.draw(frame.tables, designer.scene, veil);
    if (designer.hints_to_drag) ui::hint("Drag the highlight");
}

// What could not be kept: it stands before the last thing done.
std::string warning(const Designer& designer) {
    if (!designer.autosave.problem().empty())
        return "Unsaved work cannot be kept: " + designer.autosave.problem();
    if (!designer.settings.problem().empty()) return "Settings: " + designer.settings.problem();
    return designer.recent.problem().empty() ? "" : "Recent files: " + designer.recent.problem();
}

void draw_status(Designer& designer) {
    std::optional<ui::TablesStatus> baked;
    if (designer.frame.tables) baked = status_of(*designer.frame.tables);
    ui::status_line({.baked = std::move(baked),
                     .message = designer.files.message(),
                     .problem = designer.baker.problem(),
                     .warning = warning(designer),
                     .working = designer.baker.busy(),
                     .expert = designer.layers.expert,
                     .kept_free = ui::plots_switch_width() + 2 * ImGui::GetFontSize()});
    ui::plots_switch(designer.plots.state);
}

// Asks for tables of this design unless they are what was asked for last.
void ask(Designer& designer, const Design& shown) {
    const Frame& frame = designer.frame;
    const bool known = shown.distribution == frame.design.distribution;
    designer.baker.want({.design = shown,
                         .p = known ? frame.p : nullptr,
                         .albedo = designer.scene.ambient || designer.plots.wants_albedo(),
                         .settled = frame.settled});
}

// While p is dragged or painted a draft follows; what it rests on is baked to the end. A draft that comes
// within a moment is seen in the very frame of the edit that it answers.
void make_frame(Designer& designer) {
    Frame& frame = designer.frame;
    Design shown = shown_design(designer);
    const double now = ImGui::GetTime();
    if (shown.distribution != frame.design.distribution) designer.changed_at = now;
    frame.settled = !ImGui::IsAnyMouseDown() || now - designer.changed_at > rest_seconds;
    frame.p = nullptr;  // whatever is thrown from here on
    frame.design = std::move(shown);
    frame.p = designer.live.of(frame.design.distribution);
    frame.revision = designer.live.revision();
    ask(designer, frame.design);
    // The bake runs meanwhile.
    designer.canvas.update(frame, designer.scene, designer.layers.chosen);
    const auto longest = designer.preview.has_picture() ? patience : first_patience;
    if (auto tables = designer.baker.poll(longest)) frame.tables = std::move(tables);
}

Settings first_settings(const DesignerOptions& options) {
    Settings settings;
    Habits& habits = settings.habits;
    habits.expert = habits.has_dragged = habits.has_painted = !options.welcomes;
    return settings;
}

std::filesystem::path autosave_folder(const UserFolders& folders) {
    return folders.state.empty() ? folders.state : folders.state / "unsaved";
}

// On the disk: the newest step of undo at once, the settings while no border is dragged.
void keep(Designer& designer) {
    designer.autosave.follow(designer.document);
    if (ImGui::IsAnyMouseDown()) return;
    designer.settings.values.habits = habits_of(designer);
    designer.settings.keep();
}

// By the widget, tool or command that changed the design in this frame.
void name_edit(Designer& designer) {
    auto name = ui::take_edit_name();
    if (designer.document.design == designer.named) return;
    designer.named = designer.document.design;
    if (name) designer.document.doing = *std::move(name);
}

// What was marked on another design means nothing on this one.
void follow_document(Designer& designer) {
    if (designer.document.identity() == designer.worked_on) return;
    designer.worked_on = designer.document.identity();
    designer.canvas.state.selection.reset();
    designer.canvas.state.last_stroke.reset();
}

void draw_all(Designer& designer) {
    Document& document = designer.document;
    designer.focus.begin_frame();
    prepare_dialogs(designer);
    follow_document(designer);
    ui::close_popup_by_escape();
    end_click(designer);
    if (!talking(designer))
        if (const auto order = ui::pressed_shortcut(command_infos())) perform(designer, *order);
    if (const auto order = ui::menu_bar(command_states(designer), document.title()))
        perform(designer, *order);

    Layout& layout = designer.settings.values.layout;
    const Places places = place_parts(
        layout, {.panel = designer.panels, .drawer = designer.plots.state.open, .history = designer.history});
    take_input(places,
               {.panel = [&] { draw_panel(designer); },
                .canvas = [&] { designer.canvas.work(designer.frame, document.design, designer.layers); },
                .preview = [&] { work_on_preview(designer); },
                .history = [&] { draw_history(designer.document); }});
    designer.remake.follow(designer.layers, document.design.distribution);
    follow_hints(designer);
    follow_trial(designer);
    follow_held_key(designer);
    make_frame(designer);
    const Frame& frame = designer.frame;
    draw_parts(layout, places,
               {.canvas =
                    [&] {
                        designer.canvas.draw(frame, document.design, designer.layers,
                                             designer.preview.pointed_at());
                        if (designer.hints_to_paint) ui::hint("Paint here: B takes a brush, T a stamp");
                    },
                .preview = [&] { draw_preview(designer); },
                .drawer = [&] { designer.plots.draw(frame.tables, document.stem(), file_dialogs(designer)); },
                .status = [&] { draw_status(designer); }});
    designer.environment.follow(designer.scene.environment);
    designer.stamps.follow(designer.canvas.state, file_dialogs(designer));
    designer.pictures.follow(document.design.distribution, designer.layers.chosen,
                             designer.canvas.state.scale);
    follow_files(designer);
    draw_dialogs(designer);

    name_edit(designer);
    end_edit(designer);
    ask(designer, shown_design(designer));
    keep(designer);
    designer.focus.end_frame();
    ui::reserve_tab();
}

}  // namespace

Designer::Designer(const DesignerOptions& given)
    : options(given),
      settings(options.folders.config, first_settings(options)),
      recent(options.folders.state),
      autosave(autosave_folder(options.folders), options.autosave_bytes),
      recovery(autosave_folder(options.folders)),
      baker(options.bake_threads, options.wake),
      comparison(options.bake_threads, options.wake),
      watch(options.wake),
      pictures(options.wake),
      remake(options.wake),
      stamps(options.wake),
      exporter(options.folder_opener),
      presets(list_presets(presets_folder() / "highlights")) {
    for (Preset& start : presets) start.is_start = true;
    for (Preset& material : list_presets(presets_folder())) presets.push_back(std::move(material));
    if (!options.folders.data.empty())
        for (Preset& own : list_presets(options.folders.data / "presets")) presets.push_back(std::move(own));
    take_up(*this, settings.values.habits);
    if (options.welcomes && settings.is_first_run()) open_tab = "Presets";
    recovery.look();
}

// What is short, memory most likely, may be there again in the next frame. What was being edited goes back to
// the newest step of undo, which is whole.
void draw_frame(Designer& designer) {
    try {
        draw_all(designer);
    } catch (const std::exception&) {
        ui::abandon_frame();
        designer.document.design = designer.document.history.current();
        designer.files.report(problem_line());
    }
}

bool in_motion(const Designer& designer) {
    return !designer.frame.settled || designer.environment.in_motion() || designer.objects.in_motion() ||
           designer.stamps.in_motion() || designer.pictures.in_motion() ||
           designer.plots.saving.in_motion() || designer.preview.accumulating() ||
           designer.files.has_answer() || designer.exporter.in_motion() ||
           designer.pictures_of_preview.in_motion() || designer.thumbnails.busy() ||
           designer.comparison.in_motion() || designer.other_since.has_value();
}

void finish(Designer& designer) {
    designer.settings.keep();
    designer.autosave.finish();
}

}  // namespace nacre
