// The steps of undo by what was done in each.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace nacre::ui {

struct HistoryRow {
    std::string what;
    bool later = false;  // than the present one: it goes with the next edit
};

// From the oldest to the newest step; `present` is one of them. The list follows it. Returns the row that was
// clicked.
std::optional<std::size_t> history_panel(std::span<const HistoryRow> rows, std::size_t present);

}  // namespace nacre::ui
