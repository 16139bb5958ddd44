#include "ui/focus_pointer.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/key_press.h"
#include "ui/keys.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr const char* explanation = "Arrows move, Enter clicks, Space holds, Page Up and Down zoom, Esc ends";

bool take(int key) {
    if (!is_key_pressed(key, false)) return false;
    take_key(key);
    return true;
}

bool same(ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; }

}  // namespace

void FocusPointer::enter(ImGuiWindow* window, ImVec2 low, ImVec2 high) {
    at_ = ImVec2((low.x + high.x) / 2, (low.y + high.y) / 2);
    mouse_.reset();
    follow(window, low, high);
}

void FocusPointer::leave() {
    at_.reset();
    wheel_ = 0;
}

void FocusPointer::follow(ImGuiWindow* window, ImVec2 low, ImVec2 high) {
    window_ = window;
    low_ = low;
    high_ = high;
    // Dear ImGui takes the pointer's place in whole pixels.
    if (at_)
        at_ = ImVec2(std::floor(std::clamp(at_->x, low.x, high.x - 1)),
                     std::floor(std::clamp(at_->y, low.y, high.y - 1)));
}

void FocusPointer::tell(ImGuiIO& io) {
    const ImVec2 now = io.MousePos;
    if (at_ && mouse_ && !same(now, *mouse_) && !same(now, told_)) leave();  // the mouse has moved
    if (!at_) {
        if (std::exchange(holds_, false)) tell_left_button(io, false);
        return;
    }
    // A host that has its own pointer sets it anew before each frame, or leaves it where this one was put.
    if (!mouse_) mouse_ = now;
    if (!same(now, *at_)) tell_pointer(io, *at_);
    told_ = *at_;
    tell_left_button(io, holds_);
    if (wheel_ != 0) tell_wheel(io, std::exchange(wheel_, 0.0f));
    if (std::exchange(clicks_, false)) holds_ = false;
}

void FocusPointer::take_arrows() {
    const ImGuiIO& io = ImGui::GetIO();
    const float step = io.KeyShift ? 1 : scaled(8);
    const auto steps = [&](int less, int more) {
        const float by = is_key_pressed(more, true) ? step : is_key_pressed(less, true) ? -step : 0;
        for (const int key : {less, more})
            if (is_key_pressed(key, true)) take_key(key);
        return by;
    };
    at_->x += steps(key::left, key::right);
    at_->y += steps(key::up, key::down);
    follow(window_, low_, high_);
}

void FocusPointer::work() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (!context.OpenPopupStack.empty() || ImGui::GetIO().WantTextInput || is_key_pressed(key::f6, false) ||
        is_key_pressed(key::f10, false))
        return leave();
    if (holds_ && is_key_pressed(key::escape, false)) {
        clicks_ = true;  // the drag is taken back by whoever else sees the key, while it is held
        return;
    }
    if (take(key::escape)) return leave();
    take_arrows();
    if (take(key::enter))
        holds_ = clicks_ = true;
    else if (take(' '))
        holds_ = !holds_;
    for (const auto& [key, notches] : {std::pair(key::page_up, 1.0f), std::pair(key::page_down, -1.0f)})
        if (is_key_pressed(key, true)) {
            take_key(key);
            wheel_ += notches;
        }
}

void FocusPointer::draw() const {
    if (!at_) return;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float inner = scaled(3), outer = scaled(12);
    for (const auto& [width, colour] : {std::pair(scaled(3), IM_COL32(0, 0, 0, 160)),
                                        std::pair(scaled(1), ImGui::GetColorU32(palette::accent_bright))})
        for (const float side : {-1.0f, 1.0f}) {
            list.AddLine({at_->x + side * inner, at_->y}, {at_->x + side * outer, at_->y}, colour, width);
            list.AddLine({at_->x, at_->y + side * inner}, {at_->x, at_->y + side * outer}, colour, width);
        }
    const ImVec2 extent = ImGui::CalcTextSize(explanation);
    const float pad = scaled(6);
    const ImVec2 low(std::max(0.0f, (low_.x + high_.x - extent.x) / 2 - pad), high_.y - extent.y - 3 * pad);
    list.AddRectFilled(low, {low.x + extent.x + 2 * pad, low.y + extent.y + 2 * pad},
                       ImGui::GetColorU32(palette::accent_dim), scaled(6));
    list.AddText({low.x + pad, low.y + pad}, ImGui::GetColorU32(palette::text), explanation);
}

}  // namespace nacre::ui
