#include "app/designer/perform.h"

#include <utility>

#include "app/designer/scene_panel.h"
#include "ui/canvas_toolbar.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// Erase, and back to the tool that it was taken for.
void toggle_erase(Designer& designer) {
    ui::CanvasTool& tool = designer.canvas.state.tool;
    if (tool == ui::CanvasTool::erase) {
        tool = std::exchange(designer.tool_before_erase, std::nullopt).value_or(ui::CanvasTool::paint);
    } else {
        designer.tool_before_erase = tool;
        tool = ui::CanvasTool::erase;
    }
}

void open_recent(Designer& designer, std::size_t which) {
    const std::vector<fs::path>& files = designer.recent.files();
    if (which >= files.size()) return;
    const fs::path file = files[which];
    designer.files.open_file(designer.document, file);
}

// Whether it was one of the commands that concern files.
bool perform_on_files(Designer& designer, ui::Order order) {
    Document& document = designer.document;
    switch (order.command) {
        case ui::Command::new_design:
            designer.files.start_new(document);
            return true;
        case ui::Command::open:
            designer.files.start_open(document);
            return true;
        case ui::Command::open_recent:
            open_recent(designer, order.which);
            return true;
        case ui::Command::clear_recent:
            designer.recent.clear();
            return true;
        case ui::Command::save:
            designer.files.save(document);
            return true;
        case ui::Command::save_as:
            designer.files.save_as(document);
            return true;
        case ui::Command::export_design:
            designer.exporter.start();
            return true;
        case ui::Command::take_picture:
            designer.pictures_of_preview.take();
            return true;
        case ui::Command::picture_folder:
            designer.pictures_of_preview.choose_folder();
            return true;
        case ui::Command::system_dialogs:
            designer.settings.values.system_dialogs = !designer.settings.values.system_dialogs;
            return true;
        case ui::Command::recover:
            designer.recovery.look();
            if (!designer.recovery.talking()) designer.files.tell("No unsaved work was left behind");
            return true;
        case ui::Command::quit:
            designer.files.quit(document);
            return true;
        default:
            return false;
    }
}

}  // namespace

std::optional<DialogProgram> file_dialogs(const Designer& designer) {
    return designer.settings.values.system_dialogs ? designer.options.dialogs : std::nullopt;
}

ui::MenuState menu_state(const Designer& designer) {
    ui::MenuState state{.can_undo = designer.document.history.can_undo(),
                        .can_redo = designer.document.history.can_redo(),
                        .title = designer.document.title(),
                        .recent = {},
                        .has_system_dialogs = designer.options.dialogs.has_value(),
                        .uses_system_dialogs = designer.settings.values.system_dialogs,
                        .can_recover = !designer.options.folders.state.empty(),
                        .panels = designer.panels,
                        .full_screen = designer.full_screen};
    for (const fs::path& file : designer.recent.files()) state.recent.push_back(file.string());
    return state;
}

void perform(Designer& designer, ui::Order order) {
    if (talking(designer) || perform_on_files(designer, order)) return;
    ui::CanvasState& canvas = designer.canvas.state;
    switch (order.command) {
        case ui::Command::undo:
            designer.document.undo();
            break;
        case ui::Command::redo:
            designer.document.redo();
            break;
        case ui::Command::show_panels:
            designer.panels = !designer.panels;
            break;
        case ui::Command::full_screen:
            designer.full_screen = !designer.full_screen;
            break;
        case ui::Command::reset_camera:
            reset_camera(designer.scene);
            break;
        case ui::Command::show_shortcuts:
            designer.sheet = true;
            break;
        case ui::Command::brush_smaller:
            ui::resize_brush(canvas, -1);
            break;
        case ui::Command::brush_larger:
            ui::resize_brush(canvas, 1);
            break;
        case ui::Command::erase:
            toggle_erase(designer);
            break;
        case ui::Command::choose_layer:
            if (order.which < designer.document.design.distribution.layers.size())
                designer.layers.chosen = order.which;
            break;
        default:
            break;
    }
}

void take_file(Designer& designer, const fs::path& file) {
    if (talking(designer)) return;
    if (file.extension() == design_extension)
        designer.files.open_file(designer.document, file);
    else if (names_object(file.string()))
        designer.objects.want(file.string());
    else
        designer.pictures.offer(file);
}

}  // namespace nacre
