#include "ui/toolbar_row.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/theme.h"

namespace nacre::ui {
namespace {

float gap() { return ImGui::GetStyle().ItemInnerSpacing.x; }

}  // namespace

void ToolbarRow::add(float width, std::function<void()> draw) {
    items_.push_back({width, std::move(draw), false});
}

void ToolbarRow::add_hint(const char* words) {
    const auto draw = [words] {
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, palette::text_dim);
        ImGui::TextUnformatted(words);
        ImGui::PopStyleColor();
    };
    items_.push_back({ImGui::CalcTextSize(words).x, draw, true});
}

std::vector<ToolbarRow::Place> ToolbarRow::places(float room) const {
    std::vector<Place> places;
    float right = 0;
    for (const Item& item : items_) {
        if (item.is_hint && item.width > room) {
            places.push_back(Place::nowhere);
        } else if (right > 0 && right + gap() + item.width <= room) {
            places.push_back(Place::beside);
            right += gap() + item.width;
        } else {
            places.push_back(Place::below);
            right = item.width;
        }
    }
    return places;
}

int ToolbarRow::lines(float room) const {
    const auto all = places(room);
    return static_cast<int>(std::count(all.begin(), all.end(), Place::below));
}

void ToolbarRow::draw() const {
    const auto all = places(ImGui::GetContentRegionAvail().x);
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (all[i] == Place::nowhere) continue;
        if (all[i] == Place::beside) ImGui::SameLine(0, gap());
        items_[i].draw();
    }
}

}  // namespace nacre::ui
