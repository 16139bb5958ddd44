// The drawer of plots: what is plotted, for which directions, and the plot itself.
#pragma once

#include <imgui.h>

#include <optional>

#include "core/plot/draw_plot.h"

namespace nacre::ui {

// What the drawer remembers between frames; no part of the document.
struct PlotsState {
    bool open = false;
    PlotSettings settings;
    ShapeView view;
};

// What is shown.
struct PlotsContents {
    const Plot* plot = nullptr;  // null while there is none, ...
    const char* waiting = "";    // ... and why
    ImTextureID slice = nullptr;
};

struct PlotsAnswer {
    bool save = false;
    std::optional<PlotReading> reading;  // of what is under the pointer
};

// Fills the current window.
PlotsAnswer plots_panel(PlotsState& state, const PlotsContents& contents);

// A small switch that opens and closes the drawer, at the right end of the current line.
void plots_switch(PlotsState& state);
float plots_switch_width();

}  // namespace nacre::ui
