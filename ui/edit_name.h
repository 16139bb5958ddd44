// What the present edit is called, for the history: the widget that the hand works, or what a tool or command
// says of itself. Every widget that has a name (item_map.h) tells it here, so that no list has to be kept.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nacre::ui {

// In this frame it counts before the name of a widget; the last one counts.
void name_edit(std::string_view name);

// The last item's, where the hand works it.
void name_edit_by_item(std::string_view name);

// The name that this frame has given, once.
std::optional<std::string> take_edit_name();

}  // namespace nacre::ui
