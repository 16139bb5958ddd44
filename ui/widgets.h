// The few widgets that every panel is made of. A row is a label in the left column and a field in the
// right one; labels are unique within a panel ("text##name" tells two equal texts apart).
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "core/base/choice.h"

namespace nacre::ui {

struct SliderSpec {
    const char* label;
    double low;  // ends of the slider ...
    double high;
    double least;  // ... and what may be typed
    double most;
    double reset;  // by double click or context menu
    const char* format = "%.3f";
    bool logarithmic = false;
    const char* tooltip = nullptr;
    bool whole = false;     // no fractions
    bool infinite = false;  // "infinity" may be typed too
};

// Each returns whether the value changed.
bool slider(const SliderSpec& spec, double& value);
bool slider(SliderSpec spec, glm::dvec3& rgb, glm::dvec3 reset);  // `reset` in the place of spec.reset
// A slider with a box behind it for an infinite value; unticking brings `spec.reset`.
bool slider_or_infinity(const SliderSpec& spec, double& value);
bool colour(const char* label, glm::dvec3& linear, glm::dvec3 reset, const char* tooltip = nullptr);
bool checkbox(const char* label, bool& value, const char* tooltip = nullptr);
// One of a list. Each entry is named "LABEL ENTRY" for scripts; `explanations` are the entries' own tooltips,
// `swatch` tells the colour of an entry where they have one.
bool combo(const char* label, int& index, std::span<const char* const> names, const char* tooltip = nullptr,
           std::span<const char* const> explanations = {}, glm::dvec3 (*swatch)(std::size_t) = nullptr);
bool combo(const char* label, int& index, std::span<const Choice> list, const char* tooltip);
// A square patch of a colour, linear Rec. 709, as a display shows it, `side` pixels wide; the next item
// stands beside it.
void colour_patch(glm::dvec3 linear, float side);
bool text_field(const char* label, std::string& text, const char* hint = "", const char* tooltip = nullptr);

// Free text of several lines over the whole width: wrapped to read, a click edits it.
bool note_field(std::string& text);

bool button(const char* label, const char* tooltip = nullptr, bool enabled = true, float width = 0);
float button_width(const char* label);      // of one as wide as its text, pixels
void stay_on_line(float width, float gap);  // for a widget of this width, if it fits there
void heading(const char* text);
// A foldable part of a panel, open at first.
bool section(const char* label);
void text_row(const char* label, const std::string& text);
void dim_text(const std::string& text);
void warning_text(const std::string& text);
// A line near the lower edge of the window, over what it shows, that takes no clicks.
void hint(const char* text);
// What is to be said of something that was read, one below the other over the whole width.
void notes_row(std::span<const std::string> notes);

// Draws the label column and leaves the cursor and the item width at the field. Returns whether a double
// click on the label asks for the default.
bool row_label(const char* label, const char* tooltip);
// Explains the last item while the pointer rests on it.
void tooltip_for_item(const char* text);
void tooltip(const char* text);

}  // namespace nacre::ui
