// The keyboard's focus: every widget that is noted (item_map.h) can be reached and used without a mouse.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/focus_pointer.h"

struct ImGuiWindow;

namespace nacre::ui {

// Up and Down go through the widgets of a part of the window (or of what is popped up), F6 to the next part,
// F10 to the menus. Enter or Space acts as a click, types into a number, or brings a
// pointer to the canvas or preview (focus_pointer.h); Left and Right change a number;
// Shift+F10 or Menu opens a second menu. The ring shows from the first of these keys until the mouse presses.
class KeyboardFocus {
  public:
    KeyboardFocus();
    ~KeyboardFocus();
    KeyboardFocus(const KeyboardFocus&) = delete;
    KeyboardFocus& operator=(const KeyboardFocus&) = delete;

    // Before ImGui::NewFrame: the keyboard's pointer, while there is one, in place of the mouse.
    void tell_pointer(ImGuiIO& io) { pointer_.tell(io); }

    // Takes the keys that are for the widgets of the frame before.
    void begin_frame();
    // Draws the ring about the widget of this frame.
    void end_frame();

    // The name of the widget that has it; empty while none is shown.
    const std::string& name() const { return name_; }

    // What the current frame's widgets ask and tell; of the item that was last added.
    void note(std::string_view name);
    // The same of what is worked by a pointer: Enter or Space brings one there.
    void note_surface(std::string_view name);
    bool on_item() const;
    bool menu_wanted() const;
    // Steps that Left and Right take of the item, a number; with Shift a tenth of one. Of any other item they
    // go to its neighbours.
    double take_steps();
    // A key that changes a number is held.
    bool is_changing() const { return changing_; }

  private:
    struct Stop {
        ImGuiID id;
        ImGuiWindow* window;
        ImVec2 low, high;
        std::string name;
        bool surface = false;
    };

    std::vector<std::size_t> reachable() const;
    std::optional<std::size_t> place_in(const std::vector<std::size_t>& stops) const;
    void go_to(const Stop& stop);
    void go_along(int by);
    void leave_line();
    void go_to_part(int by);
    void act();
    void read_steps();
    void follow_popups();
    void add(std::string_view name, bool surface);

    std::vector<Stop> stops_;  // of the newest frame that is whole, or of the one that is being drawn
    ImGuiID id_ = 0;           // 0: none
    ImVec2 middle_{0, 0};      // where it was seen last
    ImGuiWindow* window_ = nullptr;
    std::string name_;
    std::vector<ImGuiID> below_;  // what had it before each thing was popped up
    bool reveals_ = false;        // the window is to be scrolled to it
    bool menu_wanted_ = false, changing_ = false;
    double steps_ = 0;
    FocusPointer pointer_;
};

// Of the designer that is drawn now; null outside a frame.
KeyboardFocus* keyboard_focus();

// As ImGui::BeginPopupContextItem(), for the keyboard too.
bool begin_second_menu(const char* name);

// Whether the last item has the focus.
bool has_focus();

}  // namespace nacre::ui
