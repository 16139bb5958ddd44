#include "ui/edit_name.h"

#include <imgui.h>

#include <utility>

namespace nacre::ui {
namespace {

std::optional<std::string> said, of_item;

}  // namespace

void name_edit(std::string_view name) { said = name; }

void name_edit_by_item(std::string_view name) {
    if (ImGui::IsItemActive() || ImGui::IsItemDeactivated() || ImGui::IsItemEdited()) of_item = name;
}

std::optional<std::string> take_edit_name() {
    auto item = std::exchange(of_item, std::nullopt);
    auto spoken = std::exchange(said, std::nullopt);
    return spoken ? std::move(spoken) : std::move(item);
}

}  // namespace nacre::ui
