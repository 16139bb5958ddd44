#include <imgui.h>

#include <algorithm>

#include "ui/dialogs.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {

std::optional<int> question(const char* title, const std::string& text,
                            const std::vector<std::string>& buttons, const std::function<void()>& fields) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 centre = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(centre, ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    const float button_width = ImGui::GetFontSize() * 7;
    const auto count = static_cast<float>(buttons.size());
    const float total = count * button_width + (count - 1) * ImGui::GetStyle().ItemSpacing.x;
    const float width = std::max(ImGui::GetFontSize() * 28, total + scaled(36));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(18), scaled(16)));
    const bool open =
        ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    if (!open) return std::nullopt;
    std::optional<int> answer;
    const bool typing = ImGui::GetIO().WantTextInput;
    ImGui::TextWrapped("%s", text.c_str());
    if (fields) {
        ImGui::Dummy(ImVec2(0, ImGui::GetFontSize() * 0.6f));
        fields();
    }
    ImGui::Dummy(ImVec2(0, ImGui::GetFontSize() * 0.6f));
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - total);
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        if (i == 0) ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
        if (button(buttons[i].c_str(), nullptr, true, button_width)) answer = static_cast<int>(i);
        if (i == 0) ImGui::PopStyleColor();
    }
    const ImGuiIO& io = ImGui::GetIO();
    if (!typing && ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_Enter], false)) answer = 0;
    if (!typing && ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_Escape], false))
        answer = static_cast<int>(buttons.size()) - 1;
    if (answer) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return answer;
}

}  // namespace nacre::ui
