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

// Indices of tiles.
struct PresetChoice {
    std::optional<std::size_t> hovered;
    std::optional<std::size_t> begun;  // a click: to begin a new design as it
    std::optional<std::size_t> added;  // the menu: to add its layers to the design
};

// `current` is marked. A tile is found by scripts as "KIND NAME"; it is at least so many text sizes wide.
PresetChoice presets_panel(std::span<const PresetTile> tiles, std::optional<std::size_t> current,
                           const char* kind = "Preset", float tile_ems = 5.6f);

}  // namespace nacre::ui
