#include "ui/presets_panel.h"

#include <imgui.h>

#include "ui/list_row.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {

std::optional<std::size_t> presets_panel(std::span<const std::string> names,
                                         std::optional<std::size_t> current) {
    std::optional<std::size_t> clicked;
    if (names.empty()) dim_text("No presets were found.");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, scaled(3)));
    for (std::size_t i = 0; i < names.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (list_row(("Preset " + names[i]).c_str(),
                     {.text = names[i], .at_right = {}, .chosen = current == i}))
            clicked = i;
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    return clicked;
}

}  // namespace nacre::ui
