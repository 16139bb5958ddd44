#include <imgui.h>

#include <algorithm>

#include "core/base/utf8.h"
#include "ui/dialogs.h"
#include "ui/escape.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {

bool begin_dialog(const char* title, float ems) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    const float width = std::min(ImGui::GetFontSize() * ems, viewport.Size.x * 0.95f);
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(18), scaled(16)));
    const bool open =
        ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    return open;
}

void end_dialog(bool done) {
    if (done) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool waiting_dialog(const char* title, const std::string& text) {
    if (!begin_dialog(title, 28)) return false;
    const bool appears = ImGui::IsWindowAppearing();
    ImGui::TextWrapped("%s", as_utf8(text).c_str());
    ImGui::Dummy(ImVec2(0, ImGui::GetFontSize() * 0.6f));
    const float width = ImGui::GetFontSize() * 7;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    const bool pressed = button("Cancel", "Give it up. Escape does too.", true, width);
    const bool given_up = pressed || (!appears && take_escape());
    end_dialog(given_up);
    return given_up;
}

std::optional<int> question(const char* title, const std::string& text,
                            const std::vector<std::string>& buttons, const std::function<void()>& fields) {
    const float button_width = ImGui::GetFontSize() * 7;
    const auto count = static_cast<float>(buttons.size());
    const float total = count * button_width + (count - 1) * ImGui::GetStyle().ItemSpacing.x;
    if (!begin_dialog(title, std::max(28.0f, (total + scaled(36)) / ImGui::GetFontSize())))
        return std::nullopt;
    std::optional<int> answer;
    // A key that is down already when the question comes up was meant for another.
    const bool appears = ImGui::IsWindowAppearing(), typing = ImGui::GetIO().WantTextInput;
    ImGui::TextWrapped("%s", as_utf8(text).c_str());
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
    if (!typing && !appears && is_key_pressed(key::enter, false)) answer = 0;
    if (!appears && take_escape()) answer = static_cast<int>(buttons.size()) - 1;
    end_dialog(answer.has_value());
    return answer;
}

}  // namespace nacre::ui
