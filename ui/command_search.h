// A field that finds what one types: commands, tools, presets, settings.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace nacre::ui {

struct SearchEntry {
    std::string name;
    std::string where;  // a menu, a panel
    std::string keys = {};
    std::string about = {};
};

// What is open, for as long as this value lives.
struct CommandSearch {
    std::string text;
    std::size_t row = 0;  // of the list, marked
    bool take_focus = true;
};

// The entries that hold every word of the text, in any case: first those whose name begins with it, then
// those whose name holds it, each in their order.
std::vector<std::size_t> found_entries(std::span<const SearchEntry> entries, const std::string& text);

struct SearchAnswer {
    bool closed = false;
    std::optional<std::size_t> chosen;
};

// Up and Down move the mark, Enter or a click chooses, Escape closes.
SearchAnswer command_search(CommandSearch& search, std::span<const SearchEntry> entries);

}  // namespace nacre::ui
