// Widgets from left to right; those that do not fit on a line go to the next.
#pragma once

#include <functional>
#include <vector>

namespace nacre::ui {

class ToolbarRow {
  public:
    // A widget of this width, pixels, at the usual distance from the one before.
    void add(float width, std::function<void()> draw);
    // Dim words; left out where a whole line is too short for them.
    void add_hint(const char* words);

    // How many lines it takes where a line is `room` pixels wide.
    int lines(float room) const;
    // From the cursor on.
    void draw() const;

  private:
    enum class Place { beside, below, nowhere };
    struct Item {
        float width;
        std::function<void()> draw;
        bool is_hint;
    };
    std::vector<Place> places(float room) const;

    std::vector<Item> items_;
};

}  // namespace nacre::ui
