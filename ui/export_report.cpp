#include "ui/export_report.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/utf8.h"
#include "ui/escape.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/status_line.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float width_ems = 30;
constexpr std::size_t files_named = 6;  // of more, their number is told

std::string list_of(const std::vector<std::string>& files) {
    std::string text;
    for (std::size_t i = 0; i < std::min(files.size(), files_named); ++i)
        text += (i > 0 ? ", " : "") + files[i];
    if (files.size() > files_named) text += " and " + std::to_string(files.size() - files_named) + " more";
    return text;
}

void step_row(std::size_t number, const std::string& step) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::accent_bright);
    ImGui::Text("%zu", number);
    ImGui::PopStyleColor();
    ImGui::SameLine(ImGui::GetFontSize() * 2);
    ImGui::TextWrapped("%s", as_utf8(step).c_str());
    note_item("Next step " + std::to_string(number));
}

ReportAnswer buttons() {
    ReportAnswer answer = ReportAnswer::none;
    const float width = ImGui::GetFontSize() * 7;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * width - ImGui::GetStyle().ItemSpacing.x);
    if (button("Open folder", "Shows the files in the desktop's file manager.", true, width))
        answer = ReportAnswer::open_folder;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
    if (button("Close##Close export report", "Enter or Escape do so too.", true, width))
        answer = ReportAnswer::closed;
    ImGui::PopStyleColor();
    return answer;
}

// A key that went down for the dialog before, or for a menu, is not for this.
bool closed_by_key() {
    if (ImGui::IsWindowAppearing() || ImGui::GetIO().WantTextInput || ImGui::IsAnyMouseDown() ||
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return false;
    return is_key_pressed(key::enter, false) || take_escape();
}

}  // namespace

ReportAnswer export_report(const ExportReport& report) {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float gap = scaled(12), width = std::min(width_ems * ImGui::GetFontSize(), window.x - 2 * gap);
    ImGui::SetNextWindowPos(ImVec2(window.x - gap, window.y - status_height() - gap), ImGuiCond_Always,
                            ImVec2(1, 1));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(18), scaled(14)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetColorU32(ImGuiCol_PopupBg));
    ImGui::Begin("Export report", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
    heading(as_utf8(report.title).c_str());
    dim_text(as_utf8(list_of(report.files) + " in " + report.folder));
    note_item("Exported files");
    for (const std::string& note : report.notes) dim_text(as_utf8(note));
    ImGui::Spacing();
    for (std::size_t i = 0; i < report.steps.size(); ++i) step_row(i + 1, report.steps[i]);
    if (!report.problem.empty()) {
        ImGui::Spacing();
        warning_text(as_utf8(report.problem));
        note_item("Open folder problem");
    }
    ImGui::Spacing();
    ReportAnswer answer = buttons();
    if (closed_by_key()) answer = ReportAnswer::closed;
    ImGui::End();
    return answer;
}

}  // namespace nacre::ui
