// Colours are linear in the design and shown encoded, as every colour picker does.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/item_map.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

// The transfer function of IEC 61966-2-1.
double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

bool colour(const char* label, glm::dvec3& linear, glm::dvec3 reset, const char* tooltip_text) {
    const glm::dvec3 before = linear;
    if (row_label(label, tooltip_text)) linear = reset;
    float shown[3];
    for (int i = 0; i < 3; ++i) shown[i] = static_cast<float>(encoded(linear[i]));
    float edited[3] = {shown[0], shown[1], shown[2]};
    ImGui::PushID(label);
    ImGui::ColorEdit3("##colour", edited, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_PickerHueWheel);
    note_item(label);
    tooltip_for_item(tooltip_text);
    ImGui::PopID();
    // A channel that was not touched keeps all its digits.
    for (int i = 0; i < 3; ++i)
        if (edited[i] != shown[i]) linear[i] = std::clamp(decoded(static_cast<double>(edited[i])), 0.0, 1.0);
    return linear != before;
}

}  // namespace nacre::ui
