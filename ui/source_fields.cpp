#include "ui/source_fields.h"

#include <imgui.h>

#include "core/base/limits.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

struct Option {
    const char* label;
    const char* tooltip;
    const char* short_label = nullptr;  // with the same name, where there is no room for both labels
};

// Two buttons side by side, the chosen one lit. Returns whether the other was chosen.
bool either(const char* label, const Option& no, const Option& yes, bool& value) {
    const bool before = value;
    row_label(label, nullptr);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const bool fits =
        button_width(no.label) + gap + button_width(yes.label) <= ImGui::GetContentRegionAvail().x;
    for (const bool second : {false, true}) {
        const Option& option = second ? yes : no;
        if (second) ImGui::SameLine(0, gap);
        const bool lit = before == second;
        if (lit) ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
        const char* text = fits || option.short_label == nullptr ? option.label : option.short_label;
        if (button(text, option.tooltip)) value = second;
        if (lit) ImGui::PopStyleColor();
    }
    return value != before;
}

bool reading_fields(NormalReading& reading, const NormalMapLook* look) {
    bool changed = either(
        "Green",
        {"Up (OpenGL)", "Green is y toward the picture's upper edge, as OpenGL has it.", "Up##Up (OpenGL)"},
        {"Down (DirectX)",
         "Green is y toward the picture's lower edge, as DirectX has it. Bumps look like dents "
         "where this is the other way round.",
         "Down##Down (DirectX)"},
        reading.green_down);
    if (look != nullptr && look->green_down && *look->green_down != reading.green_down)
        text_row("", *look->green_down ? "Its slopes fit together better with green down."
                                       : "Its slopes fit together better with green up.");
    changed |= either(
        "Numbers", {"0.5 is zero", "Each number c means 2 c - 1, as in pictures without negative numbers."},
        {"Signed", "Numbers are used as they are, negative ones too."}, reading.is_signed);
    changed |= either("Channels", {"x, y and z", "Red, green and blue are x, y and z."},
                      {"x and y", "Red and green are x and y; blue is not read, z makes the length 1."},
                      reading.two_channels);
    return changed;
}

bool smoothing_field(double& smoothing) {
    return slider({.label = "Smoothing",
                   .low = 0,
                   .high = 10,
                   .least = 0,
                   .most = limits::smoothing_max,
                   .reset = PictureSource().smoothing,
                   .format = "%.2f\u00b0",
                   .logarithmic = false,
                   .tooltip = "How far each normal is spread, as the standard deviation of its angle. 0 "
                              "leaves them as they are."},
                  smoothing);
}

bool height_field(double& height) {
    return slider({.label = "Height",
                   .low = 0,
                   .high = 20,
                   .least = -limits::relief_max,
                   .most = limits::relief_max,
                   .reset = PictureSource().height,
                   .format = "%.2f %% of the width",
                   .logarithmic = false,
                   .tooltip = "From black to white. Higher is rougher; a negative number makes black the "
                              "highest."},
                  height);
}

bool size_field(double& size) {
    return slider(
        {.label = "Size##Picture size",
         .low = 2,
         .high = 60,
         .least = limits::stamp_size_min,
         .most = limits::stamp_size_max,
         .reset = PictureSource().size,
         .format = "%.1f\u00b0",
         .logarithmic = true,
         .tooltip = "How large the picture is: the angle of the facets from its middle to its edge."},
        size);
}

}  // namespace

bool pose_fields(PictureSource& source) {
    bool changed = slider({.label = "Rotation##Picture rotation",
                           .low = -180,
                           .high = 180,
                           .least = -limits::angle_max,
                           .most = limits::angle_max,
                           .reset = 0,
                           .format = "%.1f\u00b0",
                           .logarithmic = false,
                           .tooltip = "Turns the picture, counterclockwise."},
                          source.rotation);
    changed |= checkbox("Flip##Flip picture", source.flip, "Left and right of the picture change places.");
    return changed;
}

bool source_fields(PictureSource& source, const SourceHelp& help) {
    bool changed = false;
    switch (source.as) {
        case SourceUse::stamp:
            changed |= size_field(source.size);
            break;
        case SourceUse::normals:
            changed |= reading_fields(source.reading, help.look);
            changed |= smoothing_field(source.smoothing);
            break;
        case SourceUse::heights:
            changed |= height_field(source.height);
            changed |= smoothing_field(source.smoothing);
            break;
    }
    return pose_fields(source) || changed;
}

}  // namespace nacre::ui
