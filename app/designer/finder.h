// What the search field finds, and what happens when it is chosen.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/command_search.h"

namespace nacre {

struct Designer;

struct Finding {
    ui::SearchEntry entry;
    std::function<void(Designer&)> act;
    std::string item = {};  // the name of a setting's widget, which `act` brings to the screen
};

// Commands that can be done now, tools, presets and settings.
std::vector<Finding> findings(const Designer& designer);

// Draws the field while it is open, and does what is chosen.
void draw_finder(Designer& designer);

}  // namespace nacre
