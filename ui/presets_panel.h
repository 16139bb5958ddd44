// The designs that come with the program, and the user's own, as a wall of pictures.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace nacre::ui {

struct PresetTile {
    std::string name;
    ImTextureID picture = nullptr;  // square; null while there is none
};

// Returns the index of the clicked tile; `current` is marked.
std::optional<std::size_t> presets_panel(std::span<const PresetTile> tiles,
                                         std::optional<std::size_t> current);

}  // namespace nacre::ui
