// The designs that come with the program.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace nacre::ui {

// Returns the index of the clicked name; `current` is marked.
std::optional<std::size_t> presets_panel(std::span<const std::string> names,
                                         std::optional<std::size_t> current);

}  // namespace nacre::ui
