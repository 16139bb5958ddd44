#include "ui/toolbar_fields.h"

#include <imgui.h>

#include <cmath>

#include "ui/item_map.h"
#include "ui/slider_bar.h"

namespace nacre::ui {

bool bar(const SliderSpec& spec, float width, double& value) {
    ImGui::SetNextItemWidth(width);
    return slider_field(spec, spec.label, value, false);
}

bool percent(const char* name, const char* format, const char* text, float width, double reset,
             double& part) {
    double hundredths = part * 100;
    const SliderSpec spec{.label = name,
                          .low = 0,
                          .high = 100,
                          .least = 0,
                          .most = 100,
                          .reset = reset * 100,
                          .format = format,
                          .logarithmic = false,
                          .tooltip = text};
    if (!bar(spec, width, hundredths)) return false;
    part = hundredths / 100;
    return true;
}

void whole_number(const char* name, const char* format, const WholeRange& range, float width,
                  const char* text, int& number) {
    double value = number;
    const SliderSpec spec{.label = name,
                          .low = double(range.least),
                          .high = double(range.most),
                          .least = double(range.least),
                          .most = double(range.most),
                          .reset = double(range.reset),
                          .format = format,
                          .logarithmic = false,
                          .tooltip = text,
                          .whole = true};
    if (bar(spec, width, value)) number = static_cast<int>(std::lround(value));
}

void choice(const char* name, int& index, const std::vector<std::string>& names, float width,
            const char* text) {
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo(("##" + std::string(name)).c_str(),
                                        as_label(names[static_cast<std::size_t>(index)]).c_str());
    note_item(name);
    tooltip_for_item(text);
    if (!open) return;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string label = as_label(names[i]);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(label.c_str(), static_cast<int>(i) == index)) index = static_cast<int>(i);
        ImGui::PopID();
        note_item(std::string(name) + " " + label);
    }
    ImGui::EndCombo();
}

std::vector<std::string> labels_of(std::span<const Choice> list) {
    std::vector<std::string> labels;
    for (const Choice& entry : list) labels.emplace_back(entry.label);
    return labels;
}

void combine_choice(Brush& brush, const char* name, float width) {
    int blend = static_cast<int>(brush.blend);
    choice(name, blend, labels_of(blends), width,
           "How it combines with what the layer has there: as paint does.");
    brush.blend = static_cast<Blend>(blend);
}

}  // namespace nacre::ui
