#include "ui/item_map.h"

#include "core/base/utf8.h"
#include "ui/edit_name.h"
#include "ui/focus.h"

namespace nacre::ui {
namespace {

constexpr std::string_view word_joiner = "\u2060";

ItemMap* listener() { return static_cast<ItemMap*>(ImGui::GetIO().UserData); }

// The name of one of as_label(), as the user gave it.
std::string plain_name(std::string_view label) {
    std::string name(item_name(label));
    for (std::size_t at = 0; (at = name.find(word_joiner, at)) != std::string::npos;)
        name.erase(at, word_joiner.size());
    return name;
}

}  // namespace

ItemMap::ItemMap() { ImGui::GetIO().UserData = this; }

ItemMap::~ItemMap() {
    if (ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().UserData == this)
        ImGui::GetIO().UserData = nullptr;
}

void ItemMap::clear() {
    places_.clear();
    tooltip_.clear();
}

void ItemMap::note(std::string_view name, ImVec2 low, ImVec2 high, ImVec2 clip_low, ImVec2 clip_high) {
    places_.insert_or_assign(std::string(name),
                             Place{.rectangle = {low.x, low.y, high.x, high.y},
                                   .clip = {clip_low.x, clip_low.y, clip_high.x, clip_high.y}});
}

std::optional<ImVec4> ItemMap::rectangle(std::string_view name) const {
    const auto found = places_.find(name);
    if (found == places_.end()) return std::nullopt;
    return found->second.rectangle;
}

bool ItemMap::is_in_sight(std::string_view name, ImVec2 pixel) const {
    const auto found = places_.find(name);
    if (found == places_.end()) return false;
    const ImVec4& clip = found->second.clip;
    return pixel.x >= clip.x && pixel.y >= clip.y && pixel.x < clip.z && pixel.y < clip.w;
}

std::vector<std::string> ItemMap::names() const {
    std::vector<std::string> result;
    for (const auto& [name, place] : places_) result.push_back(name);
    return result;
}

std::string_view visible_text(std::string_view label) { return label.substr(0, label.find("##")); }

std::string_view item_name(std::string_view label) {
    const auto mark = label.find("##");
    return mark == std::string_view::npos ? label : label.substr(mark + 2);
}

std::string as_label(std::string_view text) {
    std::string label;
    for (const char c : as_utf8(text)) {
        label += c;
        if (c == '#') label += word_joiner;
    }
    return label;
}

void note_item(std::string_view label) {
    if (KeyboardFocus* const focus = keyboard_focus()) focus->note(item_name(label));
    name_edit_by_item(plain_name(label));
    note_part(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void note_surface(std::string_view label) {
    if (KeyboardFocus* const focus = keyboard_focus()) focus->note_surface(item_name(label));
    note_part(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void note_part(std::string_view label, ImVec2 low, ImVec2 high) {
    auto* map = listener();
    if (map == nullptr) return;
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    map->note(plain_name(label), low, high, list.GetClipRectMin(), list.GetClipRectMax());
}

void note_tooltip(std::string_view text) {
    if (auto* map = listener()) map->note_tooltip(text);
}

}  // namespace nacre::ui
