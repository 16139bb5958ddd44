// Where each named widget stands in the current frame, so that a test, a script or a guided tour finds
// a widget by its label and survives a change of layout.
#pragma once

#include <imgui.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::ui {

class ItemMap {
  public:
    // Makes the current Dear ImGui context report its widgets here until the map is destroyed.
    ItemMap();
    ~ItemMap();
    ItemMap(const ItemMap&) = delete;
    ItemMap& operator=(const ItemMap&) = delete;

    void clear();
    void note(std::string_view name, ImVec2 low, ImVec2 high, ImVec2 clip_low, ImVec2 clip_high);
    void note_tooltip(std::string_view text) { tooltip_ = text; }
    // Left, top, right, bottom; pixels.
    std::optional<ImVec4> rectangle(std::string_view name) const;
    // Whether what the widget has there is drawn: not where its panel is scrolled away from it.
    bool is_in_sight(std::string_view name, ImVec2 pixel) const;
    std::vector<std::string> names() const;
    const std::string& tooltip() const { return tooltip_; }  // that is shown; empty without one

  private:
    struct Place {
        ImVec4 rectangle, clip;
    };

    std::map<std::string, Place, std::less<>> places_;
    std::string tooltip_;
};

// "Polar angle##second light angle" shows what stands before ## and is named by what stands after it.
std::string_view visible_text(std::string_view label);
std::string_view item_name(std::string_view label);

// What a user called something, as a label that shows it whole: Dear ImGui hides what follows "##", so a word
// joiner, which has no form of its own, stands behind each #. Bytes that are not UTF-8 are replaced.
std::string as_label(std::string_view text);

// Reports the last drawn widget under its label, if somebody listens; one of as_label() under the text. The
// keyboard's focus can come to it, and while it is worked, the edit has this name: see edit_name.h.
void note_item(std::string_view label);

// The same for what is worked by a pointer: the keyboard's focus brings one there.
void note_surface(std::string_view label);

// The same for a part of a widget that has a name of its own, or for what only the mouse works on.
void note_part(std::string_view label, ImVec2 low, ImVec2 high);

// Reports the tooltip of this frame.
void note_tooltip(std::string_view text);

}  // namespace nacre::ui
