// Input events as text, one a line, that drive the interface as hands would:
//
//   move PLACE                       down left|right|middle      up left|right|middle
//   click PLACE [left|right|middle]  drag PLACE PLACE [FRAMES]   wheel DY
//   key Ctrl+S                       text "..."                  frames N
//   wait                             drop "FILE"                 focus
//   # comment
//
// PLACE is `X Y` in pixels from the window's left top, or a widget by its name: "Weight" is its middle,
// "Weight":0.2 a fifth of the way from its left, "Weight":0.2,0.9 also from its top. "Canvas":@30,45 is where
// the canvas shows the facet normal of theta 30 and phi 45 degrees. In quotes a backslash takes the next
// character as it is. `wait` goes on when the bake is done. docs/event-scripts.md tells more.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/headless/input.h"

namespace nacre {

struct Place {
    std::string widget;        // empty: `at` is in pixels
    glm::vec2 at{0.5f, 0.5f};  // of the widget's width and height
    bool polar = false;        // `at` is theta and phi of a normal instead, degrees
    bool operator==(const Place&) const = default;
};

namespace events {
struct Move {
    Place to;
};
struct Button {
    int button = 0;  // as Dear ImGui numbers them
    bool down = true;
};
struct Click {
    Place at;
    int button = 0;
};
struct Drag {
    Place from;
    Place to;
    int frames = 10;
};
struct Wheel {
    float notches = 0;
};
struct Key {
    ui::KeyPress press;
};
struct Text {
    std::string utf8;
};
struct Frames {
    int count = 1;
};
struct Wait {};
struct Drop {
    std::string file;
};
struct Focus {};
}  // namespace events

struct Event {
    std::variant<events::Move, events::Button, events::Click, events::Drag, events::Wheel, events::Key,
                 events::Text, events::Frames, events::Wait, events::Drop, events::Focus>
        what;
    int line = 0;
};

struct EventScript {
    std::string file;  // for messages
    std::vector<Event> events;
};

// What is wrong with the text is a UserError at its line.
EventScript parse_events(std::string_view text, const std::string& file_for_errors);

}  // namespace nacre
