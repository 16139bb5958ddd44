// One line of a list: a text at the left, a shorter one at the right, shaded while chosen.
#pragma once

#include <string>

namespace nacre::ui {

struct ListRow {
    std::string text;
    std::string at_right;
    bool chosen = false;
    bool dimmed = false;
    float free_at_right = 0;  // pixels of the line
};

// Fills the rest of the line but for what is kept free. Returns whether it was clicked.
bool list_row(const char* name, const ListRow& row);

}  // namespace nacre::ui
