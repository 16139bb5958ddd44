// Colours are linear in the design and in the three fields, as tables of measured reflectance print them; the
// swatch beside them shows and picks the colour as a display does.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/paint/srgb.h"
#include "ui/item_map.h"
#include "ui/slider_bar.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

// The inverse of srgb_encoded().
double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

void linear_fields(const char* label, glm::dvec3& linear, glm::dvec3 reset, const char* tooltip_text) {
    static constexpr const char* channels[] = {" red", " green", " blue"};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width =
        std::floor((ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - 3 * gap) / 3);
    ImGui::BeginGroup();
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        slider_field({.label = label,
                      .low = 0,
                      .high = 1,
                      .least = 0,
                      .most = 1,
                      .reset = reset[i],
                      .format = "%.3f",
                      .logarithmic = false,
                      .tooltip = tooltip_text},
                     std::string(item_name(label)) + channels[i], linear[i], false);
    }
    ImGui::EndGroup();
    note_item(label);
}

// A channel that was not touched keeps all its digits.
void swatch(glm::dvec3& linear) {
    float values[3], shown[3];
    for (int i = 0; i < 3; ++i) values[i] = shown[i] = static_cast<float>(srgb_encoded(linear[i]));
    ImGui::ColorEdit3(
        "##swatch", values,
        ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_PickerHueWheel);
    for (int i = 0; i < 3; ++i)
        if (values[i] != shown[i]) linear[i] = std::clamp(decoded(static_cast<double>(values[i])), 0.0, 1.0);
}

}  // namespace

bool colour(const char* label, glm::dvec3& linear, glm::dvec3 reset, const char* tooltip_text) {
    const glm::dvec3 before = linear;
    if (row_label(label, tooltip_text)) linear = reset;
    ImGui::PushID(label);
    linear_fields(label, linear, reset, tooltip_text);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    swatch(linear);
    ImGui::PopID();
    return linear != before;
}

}  // namespace nacre::ui
