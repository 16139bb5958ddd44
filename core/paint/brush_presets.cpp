#include "core/paint/brush_presets.h"

namespace nacre {

std::vector<NamedBrush> built_in_brushes() {
    return {
        {"Soft round", {}},
        {"Hard round", {.hardness = 0.95, .flow = 1}},
        {"Fine pen", {.radius = 1.5, .hardness = 0.8, .flow = 1, .spacing = 0.1}},
        {"Airbrush", {.radius = 16, .hardness = 0, .flow = 0.06, .spacing = 0.1}},
        {"Faint glow", {.radius = 35, .hardness = 0, .flow = 0.5, .value = 0.15, .blend = Blend::maximum}},
        {"Dots", {.radius = 3, .hardness = 0.9, .flow = 1, .spacing = 2}}};
}

}  // namespace nacre
