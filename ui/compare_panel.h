// Snapshots, and what is seen beside what.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace nacre::ui {

enum class CompareView { off, divider, difference };

// What the panel edits. A side names a choice by its id.
struct CompareState {
    CompareView view = CompareView::off;
    int left = 0, right = 0;
    double amplification = 4;
    bool is_signed = false;
};

// Something that a side can show.
struct SideChoice {
    int id = 0;
    std::string label;
    std::string about;     // for the tooltip
    bool possible = true;  // `about` says why not
};

struct SnapshotRow {
    std::string letter;  // "A"
    std::string* name;   // edited in place
};

enum class SnapshotAction { take, restore, remove };

struct SnapshotRequest {
    SnapshotAction action;
    std::size_t snapshot = 0;  // of the rows
};

// `numbers` say how far the two sides are apart; empty where nothing is compared.
std::optional<SnapshotRequest> compare_panel(CompareState& state, std::span<const SnapshotRow> snapshots,
                                             std::span<const SideChoice> choices, const std::string& numbers);

}  // namespace nacre::ui
