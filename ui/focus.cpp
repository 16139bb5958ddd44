#include "ui/focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "ui/key_press.h"
#include "ui/keys.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

KeyboardFocus* current = nullptr;

bool take(const KeyPress& press) {
    if (!is_pressed(press, false)) return false;
    take_key(press.key);
    return true;
}

// The newest thing that is popped up, if it is drawn.
ImGuiWindow* popup() {
    const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
    return open.empty() ? nullptr : open.back().Window;
}

bool is_within(const ImGuiWindow* window, const ImGuiWindow* outer) {
    for (; window != nullptr; window = window->ParentWindow)
        if (window == outer) return true;
    return false;
}

// That the last item is in: not the list or menu that it has just opened, in which nothing is drawn yet.
ImGuiWindow* window_of_item() {
    ImGuiWindow* const window = ImGui::GetCurrentWindow();
    const ImVec2 at = window->DC.CursorPos, start = window->DC.CursorStartPos;
    const bool opened = (window->Flags & ImGuiWindowFlags_Popup) != 0 && at.x == start.x && at.y == start.y;
    return opened ? window->ParentWindow : window;
}

// A click on the item in the next frame.
void activate(ImGuiID id) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavNextActivateId = id;
    context.NavNextActivateFlags = ImGuiActivateFlags_None;
    context.NavInputSource = ImGuiInputSource_Keyboard;  // else a text field would not take the keyboard
}

}  // namespace

KeyboardFocus::KeyboardFocus() = default;
KeyboardFocus::~KeyboardFocus() {
    if (current == this) current = nullptr;
}

KeyboardFocus* keyboard_focus() { return current; }

// Those of the topmost popup, or all.
std::vector<std::size_t> KeyboardFocus::reachable() const {
    const ImGuiWindow* const top = popup();
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < stops_.size(); ++i)
        if (top == nullptr || is_within(stops_[i].window, top)) found.push_back(i);
    return found;
}

// Where the focus stands among them: on its widget, else on the one nearest to where that was.
std::optional<std::size_t> KeyboardFocus::place_in(const std::vector<std::size_t>& stops) const {
    std::optional<std::size_t> nearest;
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const Stop& stop = stops_[stops[i]];
        if (stop.id == id_) return i;
        if (window_ == nullptr || stop.window->RootWindow != window_->RootWindow) continue;
        const ImVec2 off((stop.low.x + stop.high.x) / 2 - middle_.x,
                         (stop.low.y + stop.high.y) / 2 - middle_.y);
        const float distance = off.x * off.x + off.y * off.y;
        if (distance < least) least = distance, nearest = i;
    }
    return nearest;
}

void KeyboardFocus::go_to(const Stop& stop) {
    id_ = stop.id;
    window_ = stop.window;
    name_ = stop.name;
    middle_ = {(stop.low.x + stop.high.x) / 2, (stop.low.y + stop.high.y) / 2};
    reveals_ = true;
}

// Through the widgets of the part that it is in, round and round.
void KeyboardFocus::go_along(int by) {
    std::vector<std::size_t> stops = reachable();
    if (stops.empty()) return;
    const auto place = place_in(stops);
    if (!place) return go_to(stops_[stops.front()]);
    const ImGuiWindow* const part = stops_[stops[*place]].window->RootWindow;
    const bool stands = stops_[stops[*place]].id == id_;
    std::erase_if(stops, [&](std::size_t i) { return stops_[i].window->RootWindow != part; });
    const auto at = static_cast<std::ptrdiff_t>(*place_in(stops)), count = std::ssize(stops);
    go_to(stops_[stops[static_cast<std::size_t>(stands ? (at + by + count) % count : at)]]);
}

// Up and Down leave a line of text that is being typed; a text of several lines keeps them.
void KeyboardFocus::leave_line() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImGuiID active = context.ActiveId;
    if (active == 0 || context.InputTextState.ID != active ||
        (context.InputTextState.Flags & ImGuiInputTextFlags_Multiline) != 0)
        return;
    const int by = is_pressed({.key = key::down}, true) ? 1 : is_pressed({.key = key::up}, true) ? -1 : 0;
    const auto here = std::ranges::find(stops_, active, &Stop::id);
    if (by == 0 || here == stops_.end()) return;
    ImGui::ClearActiveID();
    go_to(*here);
    go_along(by);
}

void KeyboardFocus::go_to_part(int by) {
    const std::vector<std::size_t> stops = reachable();
    std::vector<std::size_t> firsts;  // of each part
    for (const std::size_t i : stops)
        if (std::ranges::none_of(firsts, [&](std::size_t first) {
                return stops_[first].window->RootWindow == stops_[i].window->RootWindow;
            }))
            firsts.push_back(i);
    if (firsts.empty()) return;
    const auto here = std::ranges::find_if(firsts, [&](std::size_t first) {
        return window_ != nullptr && stops_[first].window->RootWindow == window_->RootWindow;
    });
    const auto count = std::ssize(firsts);
    const auto at = here == firsts.end() ? (by > 0 ? -1 : 0) : here - firsts.begin();
    go_to(stops_[firsts[static_cast<std::size_t>((at + by + count) % count)]]);
}

void KeyboardFocus::act() {
    const auto here = std::ranges::find(stops_, id_, &Stop::id);
    if (here == stops_.end()) return;
    if (take({.key = key::enter}) || take({.key = ' '})) {
        if (here->surface)
            pointer_.enter(here->window, here->low, here->high);
        else
            activate(id_);
    }
    menu_wanted_ = take({.key = key::menu}) || take({.key = key::f10, .shift = true});
}

// Into what has popped up since, and back to what had it before.
void KeyboardFocus::follow_popups() {
    const auto depth = static_cast<std::size_t>(ImGui::GetCurrentContext()->OpenPopupStack.Size);
    if (below_.size() > depth) {
        id_ = below_[depth];
        below_.resize(depth);
        for (const Stop& stop : stops_)
            if (stop.id == id_) go_to(stop);
    }
    if (below_.size() == depth || popup() == nullptr) return;
    const std::vector<std::size_t> stops = reachable();
    if (stops.empty()) return;  // not drawn yet
    below_.resize(depth, id_);
    if (std::ranges::none_of(stops, [&](std::size_t i) { return stops_[i].id == id_; }))
        go_to(stops_[stops.front()]);
}

void KeyboardFocus::begin_frame() {
    current = this;
    menu_wanted_ = changing_ = false;
    steps_ = 0;
    const ImGuiIO& io = ImGui::GetIO();
    if (pointer_.active()) {
        pointer_.work();
        if (pointer_.active()) return stops_.clear();
    } else if (ImGui::IsAnyMouseDown()) {
        id_ = 0;
        name_.clear();
    }
    if (id_ != 0) follow_popups();
    if (io.WantTextInput) leave_line();
    if (!io.WantTextInput && !ImGui::IsAnyMouseDown()) {
        if (is_pressed({.key = key::down}, true))
            go_along(1);
        else if (is_pressed({.key = key::up}, true))
            go_along(-1);
        else if (popup() == nullptr && (take({.key = key::f6}) || take({.key = key::f6, .shift = true})))
            go_to_part(io.KeyShift ? -1 : 1);
        else if (popup() == nullptr && take({.key = key::f10}) && !stops_.empty())
            go_to(stops_.front());
        else if (id_ != 0)
            act();
        if (id_ != 0) read_steps();
    }
    stops_.clear();
}

void KeyboardFocus::read_steps() {
    for (const bool shift : {false, true}) {
        const double step = shift ? 0.1 : 1;
        if (is_pressed({.key = key::right, .shift = shift}, true)) steps_ = step;
        if (is_pressed({.key = key::left, .shift = shift}, true)) steps_ = -step;
    }
    changing_ = is_key_down(key::left) || is_key_down(key::right);
}

void KeyboardFocus::end_frame() {
    if (steps_ != 0) go_along(steps_ > 0 ? 1 : -1);
    const auto here = std::ranges::find(stops_, id_, &Stop::id);
    if (id_ != 0 && here != stops_.end()) {
        window_ = here->window;
        name_ = here->name;
        middle_ = {(here->low.x + here->high.x) / 2, (here->low.y + here->high.y) / 2};
        const float off = scaled(2);
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        const ImRect clip = here->window->ClipRect;
        list.PushClipRect({clip.Min.x - off, clip.Min.y - off}, {clip.Max.x + off, clip.Max.y + off});
        list.AddRect({here->low.x - off, here->low.y - off}, {here->high.x + off, here->high.y + off},
                     ImGui::GetColorU32(palette::accent_bright), ImGui::GetStyle().FrameRounding, 0, off);
        list.PopClipRect();
        pointer_.follow(here->window, here->low, here->high);
        pointer_.draw();
    } else if (popup() == nullptr) {
        name_.clear();
    }
}

void KeyboardFocus::note(std::string_view name) { add(name, false); }
void KeyboardFocus::note_surface(std::string_view name) { add(name, true); }

void KeyboardFocus::add(std::string_view name, bool surface) {
    const ImGuiLastItemData& item = ImGui::GetCurrentContext()->LastItemData;
    if (item.ID == 0 || (item.InFlags & ImGuiItemFlags_Disabled) != 0) return;
    ImGuiWindow* const window = window_of_item();
    if (std::ranges::find(stops_, item.ID, &Stop::id) != stops_.end()) return;
    stops_.push_back({item.ID, window, item.Rect.Min, item.Rect.Max, std::string(name), surface});
    if (item.ID != id_ || !reveals_) return;
    ImGui::ScrollToBringRectIntoView(window, item.Rect);
    reveals_ = false;
}

bool KeyboardFocus::on_item() const { return id_ != 0 && ImGui::GetItemID() == id_; }
bool KeyboardFocus::menu_wanted() const { return menu_wanted_ && on_item(); }
double KeyboardFocus::take_steps() { return on_item() ? std::exchange(steps_, 0) : 0; }

bool begin_second_menu(const char* name) {
    if (current != nullptr && current->menu_wanted()) ImGui::OpenPopup(name);
    return ImGui::BeginPopupContextItem(name);
}

bool has_focus() { return current != nullptr && current->on_item(); }

}  // namespace nacre::ui
