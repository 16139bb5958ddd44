// The last row of a list: one more, one less.
#pragma once

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "core/model/kinds/parameter.h"
#include "ui/edit_name.h"
#include "ui/item_map.h"
#include "ui/widgets.h"

namespace nacre::ui {

// "Add ROW" puts what `make()` returns behind the others, "Remove ROW" takes the last away. `rows_min` and
// `rows_max` bound their number. Returns whether the list changed.
template <class Row, class Make>
bool list_buttons(std::vector<Row>& rows, std::size_t rows_min, std::size_t rows_max,
                  const ParameterText& text, const char* row, const Make& make) {
    const std::string add = fmt::format("Add {}", row), remove = fmt::format("Remove {}", row);
    row_label(text.label, text.tooltip);
    ImGui::BeginGroup();
    const bool added = button(add.c_str(), text.tooltip, rows.size() < rows_max);
    stay_on_line(button_width(remove.c_str()), ImGui::GetStyle().ItemInnerSpacing.x);
    const bool removed = button(remove.c_str(), "Takes the last one away.", rows.size() > rows_min);
    ImGui::EndGroup();
    note_part(text.label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    if (added) rows.push_back(make());
    if (removed) rows.pop_back();
    if (added || removed) name_edit(added ? add : remove);
    return added || removed;
}

}  // namespace nacre::ui
