#include "app/designer/dialogs_in_turn.h"

#include <optional>
#include <string>
#include <utility>

#include "app/designer/command.h"
#include "app/designer/finder.h"
#include "ui/shortcut_sheet.h"

namespace nacre {
namespace {

void tell(Designer& designer, const std::optional<std::string>& message) {
    if (message) designer.files.tell(*message);
}

void take_in_hand(ui::CanvasState& canvas, ImageImport::Stamp stamp) {
    canvas.stamps.push_back(std::move(stamp.stamp));
    canvas.stamp = canvas.stamps.size() - 1;
    canvas.pose = stamp.pose;
}

}  // namespace

void draw_dialogs(Designer& designer) {
    Document& document = designer.document;
    if (!talking(designer)) designer.exporter.draw_report();
    const bool talked = designer.files.talking();
    designer.files.draw(document);
    if (auto restored = designer.files.take_restored()) {
        designer.autosave.take_over(std::move(*restored), document.history.document());
        notice_focus(designer);
    }
    // The next question does not take the key that answered this one.
    if (talked || designer.files.talking()) return;
    if (auto found = designer.recovery.draw())
        designer.files.restore(document, std::move(*found));
    else if (designer.sheet)
        designer.sheet = ui::shortcut_sheet(command_infos(), show_shortcuts_command.info.keys);
    else if (designer.search)
        draw_finder(designer);
    else if (designer.changed_pictures.talking())
        tell(designer, designer.changed_pictures.draw(document, designer.environment, designer.objects));
    else if (designer.exporter.talking())
        tell(designer, designer.exporter.draw(document, designer.preview, designer.scene));
    else if (designer.pictures_of_preview.talking() || designer.pictures_of_preview.in_motion())
        tell(designer, designer.pictures_of_preview.draw(document, designer.preview, designer.scene));
    else if (designer.plots.saving.talking())
        tell(designer, designer.plots.saving.draw());
    else if (designer.objects.talking())
        designer.objects.talk();
    else if (designer.environment.talking())
        designer.environment.talk();
    else if (designer.stamps.talking())
        designer.stamps.talk();
    else
        designer.pictures.draw(document.design.distribution);
    tell(designer, designer.pictures.take_note());
    tell(designer, designer.stamps.take_note());
    if (auto stamp = designer.pictures.take_stamp()) take_in_hand(designer.canvas.state, *std::move(stamp));
    if (const char* panel = designer.pictures.take_panel()) designer.open_tab = panel;
    if (auto picture = designer.pictures.take_environment()) designer.environment.want(picture->string());
}

bool talking(const Designer& designer) {
    return designer.changed_pictures.talking() || designer.files.talking() || designer.pictures.talking() ||
           designer.recovery.talking() || designer.exporter.talking() ||
           designer.pictures_of_preview.talking() || designer.sheet || designer.search ||
           designer.environment.talking() || designer.objects.talking() || designer.stamps.talking() ||
           designer.plots.saving.talking();
}

}  // namespace nacre
