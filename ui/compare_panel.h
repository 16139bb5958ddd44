// Snapshots, and what is seen beside what.
#pragma once

#include <imgui.h>

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
    int id = 0;                     // as a choice of a side
    std::string letter;             // "A"
    std::string* name = nullptr;    // edited in place
    ImTextureID picture = nullptr;  // square; null while there is none
};

enum class SnapshotAction { take, restore, remove, to_left, to_right };

struct SnapshotRequest {
    SnapshotAction action;
    std::size_t snapshot = 0;  // of the rows
};

// `numbers` say how far the two sides are apart; empty where nothing is compared.
std::optional<SnapshotRequest> compare_panel(CompareState& state, std::span<const SnapshotRow> snapshots,
                                             std::span<const SideChoice> choices, const std::string& numbers);

}  // namespace nacre::ui
