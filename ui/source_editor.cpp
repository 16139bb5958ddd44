#include <imgui.h>

#include "core/base/utf8.h"
#include "ui/layers_panel.h"
#include "ui/source_fields.h"
#include "ui/widgets.h"

namespace nacre::ui {

void source_editor(const Layer& layer, LayersView& view) {
    if (!layer.source) return;
    const bool being_made = view.remake && view.remake->layer == view.chosen;
    PictureSource source = being_made ? view.remake->source : *layer.source;
    ImGui::Spacing();
    heading("Made from a picture");
    text_row("Picture", as_utf8(source.image.filename().string()));
    bool changed = source_fields(source);
    changed |= button("Read again##Read picture again",
                      "Make the layer once more from the picture as it is on the disk now.");
    if (being_made) {
        ImGui::SameLine();
        dim_text("Being made \u2026");
    }
    if (changed) view.remake = LayersView::Remake{view.chosen, source};
    if (view.source_trouble && view.source_trouble->image == source.image) {
        warning_text(as_utf8(view.source_trouble->words));
        dim_text("The layer stays as it is.");
    }
}

}  // namespace nacre::ui
