#include "ui/status_line.h"

#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

// A dot that tells whether the picture is final without anything moving.
void dot(const Colour& colour) {
    const float size = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + size * 0.3f, corner.y + size * 0.54f},
                                                size * 0.24f, ImGui::GetColorU32(colour));
    ImGui::Dummy(ImVec2(size * 0.6f, size));
    ImGui::SameLine();
}

void right_aligned(const std::string& text, float kept_free) {
    const float left = ImGui::GetWindowWidth() - kept_free - ImGui::CalcTextSize(text.c_str()).x -
                       ImGui::GetStyle().WindowPadding.x;
    ImGui::SameLine(left);
    ImGui::TextUnformatted(text.c_str());
}

}  // namespace

float status_height() { return ImGui::GetFontSize() * 1.9f; }

void status_line(const Status& status) {
    const bool refused = !status.problem.empty();
    dot(refused ? palette::red : status.working ? palette::amber : palette::accent);
    if (refused) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::red);
        ImGui::TextUnformatted(status.problem.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) tooltip(status.problem.c_str());
        return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, palette::text_dim);
    ImGui::TextUnformatted(status.tables.empty() ? "baking\u2026" : status.tables.c_str());
    tooltip_for_item(
        "What was baked for this picture: draft or final; nodes of each table along the angle from the "
        "normal and around it; the symmetry that was used; memory; time; and the worst errors, measured "
        "between the nodes: of the projected area g, in parts of itself, and of the albedo R, in parts of "
        "the "
        "light that falls in.");
    if (!status.warning.empty()) ImGui::PushStyleColor(ImGuiCol_Text, palette::amber);
    right_aligned(status.warning.empty() ? status.message : status.warning, status.kept_free);
    if (!status.warning.empty()) {
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) tooltip(status.warning.c_str());
    }
    ImGui::PopStyleColor();
}

}  // namespace nacre::ui
