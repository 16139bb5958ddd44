// A list of commands as the designer has one.
#pragma once

#include <array>

#include "ui/commands.h"

namespace some_commands {

enum : std::size_t { save, undo, redo, smaller, larger, layer };

inline constexpr nacre::ui::CommandInfo info[] = {
    {.menu = "File", .label = "Save", .keys = "Ctrl+S", .about = "Writes it."},
    {.menu = "Edit", .label = "Undo", .keys = "Ctrl+Z", .about = "Takes it back.", .repeats = true},
    {.menu = "Edit", .label = "Redo", .keys = "Ctrl+Shift+Z", .also = "Ctrl+Y", .about = "Does it again."},
    {.menu = "Canvas", .label = nullptr, .keys = "[", .also = ",", .about = "Smaller."},
    {.menu = "Canvas", .label = nullptr, .keys = "]", .also = ".", .about = "Larger."},
    {.menu = "Canvas", .label = nullptr, .keys = nacre::ui::nine_digits, .about = "A layer."},
};

inline nacre::ui::CommandInfos infos() {
    static const auto list = [] {
        std::array<const nacre::ui::CommandInfo*, std::size(info)> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = &info[i];
        return all;
    }();
    return list;
}

}  // namespace some_commands
