// What an artist left set: tool, brushes, how the canvas is shown, the object and from where it is seen. Part
// of the settings.
#pragma once

#include <string>
#include <vector>

#include "core/base/json_reader.h"
#include "core/paint/brush_presets.h"
#include "core/paint/density_picture.h"
#include "core/paint/stroke.h"

namespace nacre {

struct Habits {
    std::string tool = "Handles";  // its name
    Brush brush;
    double steadiness = 0;
    std::vector<NamedBrush> own_brushes;
    double tolerance = usual_tolerance;        // of fill
    GradientForm form = GradientForm::linear;  // of gradient
    ScaleKind scale = ScaleKind::perceptual;
    bool highlight = true;
    bool expert = true;
    bool has_dragged = true, has_painted = true;  // the highlight, on the canvas: no hint says how
    std::string object = "sphere";                // one that is built in
    double yaw = 0, pitch = 0, zoom = 1;

    bool operator==(const Habits&) const = default;
};

// The value of the settings' key "habits". What is wrong is a UserError.
Habits read_habits(const JsonValue& json);
std::string habits_text(const Habits& habits);

}  // namespace nacre
