// The presets: seen while they are pointed at, begun as a new document, or added as layers.
#pragma once

#include <filesystem>
#include <optional>

#include "core/design/design.h"

namespace nacre {

struct Designer;

// A preset that is looked at in the place of the design.
struct Trial {
    std::filesystem::path file;
    Design design;
};

void draw_presets(Designer& designer);

// After the panel's input: shows the preset that was pointed at in this frame, or the design.
void follow_trial(Designer& designer);

// The layers of `added` after those of `design`; together they get half as many facets as those had. A
// UserError where they would be more layers than a design holds.
void add_layers(Distribution& distribution, const Distribution& added, const std::string& name);

}  // namespace nacre
