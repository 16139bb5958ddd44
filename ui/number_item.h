// What all fields of numbers are made of: an item that is dragged or typed into. What is typed holds as soon
// as it is a number that is allowed; until then, and after Escape, the old one does.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/widgets.h"

namespace nacre::ui {

enum class NumberHandling {
    slide,  // a drag slides between `low` and `high`; Ctrl+click or Tab begins to type
    type    // a click begins to type
};

struct NumberItem {
    ImVec2 low, high;      // corners
    bool hovered = false;  // by the pointer
    bool typing = false;   // it draws itself
};

// Over the width set for the next item, within an ID of its own. `name`: of the item, by which also its
// complaint is found, as "NAME problem".
NumberItem number_item(const SliderSpec& spec, NumberHandling handling, const std::string& name,
                       double& value);

// Where on the screen a slider from `low` to `high` has the mark of a value.
float slider_mark(const SliderSpec& spec, double value, float low, float high);
// How near to the ends that can be, pixels.
float slider_margin();

// Whether a slider was clicked and not dragged, so that a second click would make of both a double click,
// which resets: they are one change.
bool slider_awaits_second_click();

}  // namespace nacre::ui
