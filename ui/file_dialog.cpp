#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/base/utf8.h"
#include "ui/dialogs.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

namespace fs = std::filesystem;

const char* accept_label(const FileDialog& dialog) {
    switch (dialog.purpose) {
        case FileDialog::Purpose::open:
            return "Open##Accept";
        case FileDialog::Purpose::save:
            return "Save##Accept";
        case FileDialog::Purpose::folder:
            return "Use##Accept";
    }
    return "";
}

void enter(FileDialog& dialog, const ListDirectory& list, const fs::path& folder) {
    const fs::path name =
        dialog.purpose == FileDialog::Purpose::save ? fs::path(dialog.path).filename() : fs::path();
    dialog.listing = list(folder);
    dialog.path = name.string();
    dialog.problem.clear();
    dialog.take_focus = true;
}

// Where the reader is, with a way up.
void folder_line(FileDialog& dialog, const ListDirectory& list) {
    const fs::path here = dialog.listing.directory;
    if (button("\u2191##Parent folder", "The folder above.",
               here.has_parent_path() && here != here.root_path()))
        enter(dialog, list, here.parent_path());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    dim_text(as_utf8(dialog.listing.directory.string()));
}

// Returns whether a file was double-clicked.
bool entry_list(FileDialog& dialog, const ListDirectory& list) {
    bool accepted = false;
    fs::path folder;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::canvas);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(8), scaled(6)));
    const float height = -(2 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() +
                           ImGui::GetStyle().ItemSpacing.y);
    ImGui::BeginChild("entries", ImVec2(0, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    for (const DirectoryEntry& entry : dialog.listing.entries) {
        const std::string label = as_label(entry.name) + (entry.is_directory ? "/" : "");
        if (entry.is_directory) ImGui::PushStyleColor(ImGuiCol_Text, palette::accent_bright);
        const bool pressed =
            ImGui::Selectable(label.c_str(), dialog.path == entry.name,
                              ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
        if (entry.is_directory) ImGui::PopStyleColor();
        note_item(label);
        if (!pressed) continue;
        if (entry.is_directory) {
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
                folder = dialog.listing.directory / entry.name;
        } else {
            dialog.path = entry.name;
            dialog.problem.clear();
            accepted = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        }
    }
    if (dialog.listing.entries.empty())
        dim_text(dialog.listing.problem.empty() ? "Nothing to choose here." : dialog.listing.problem);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    if (!folder.empty()) enter(dialog, list, folder);
    return accepted;
}

// Returns whether Enter was pressed in the field.
bool path_field(FileDialog& dialog) {
    if (dialog.take_focus) ImGui::SetKeyboardFocusHere();
    dialog.take_focus = false;
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool entered =
        ImGui::InputTextWithHint("##path", dialog.hint.c_str(), &dialog.path,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    note_item("Path");
    ImGui::PushStyleColor(ImGuiCol_Text, palette::red);
    ImGui::TextUnformatted(dialog.problem.c_str());
    ImGui::PopStyleColor();
    return entered;
}

// `escape`: it is for the dialog.
DialogAnswer buttons(FileDialog& dialog, bool escape) {
    const float width = ImGui::GetFontSize() * 7;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * width - ImGui::GetStyle().ItemSpacing.x);
    ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
    const bool enough = !dialog.path.empty() || dialog.purpose == FileDialog::Purpose::folder;
    const bool accept = button(accept_label(dialog), nullptr, enough, width);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (button("Cancel", nullptr, true, width) || escape) return DialogAnswer::cancelled;
    return accept ? DialogAnswer::accepted : DialogAnswer::none;
}

DialogAnswer contents(FileDialog& dialog, const ListDirectory& list, fs::path& chosen) {
    folder_line(dialog, list);
    const bool double_clicked = entry_list(dialog, list);
    // Escape brings back what the field began with, and else closes the dialog.
    const std::string typed = dialog.path;
    const bool entered = path_field(dialog);
    const bool escape = is_key_pressed(key::escape, false);
    DialogAnswer answer = buttons(dialog, escape && dialog.path == typed);
    if (double_clicked || entered) answer = DialogAnswer::accepted;
    if (answer != DialogAnswer::accepted) return answer;
    if (dialog.path.empty()) {
        chosen = dialog.listing.directory;
        return dialog.purpose == FileDialog::Purpose::folder ? answer : DialogAnswer::none;
    }
    chosen = (dialog.listing.directory / dialog.path).lexically_normal();
    const Listing as_folder = list(chosen);
    if (as_folder.problem.empty()) {
        dialog.listing = as_folder;
        dialog.path.clear();
        dialog.take_focus = true;
        return DialogAnswer::none;
    }
    return DialogAnswer::accepted;
}

}  // namespace

DialogAnswer file_dialog(FileDialog& dialog, const ListDirectory& list, fs::path& chosen) {
    const char* title = dialog.title.c_str();
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float size = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(
        ImVec2(std::min(size * 40, viewport.Size.x * 0.9f), std::min(size * 30, viewport.Size.y * 0.85f)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(18), scaled(16)));
    const bool open =
        ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    ImGui::PopStyleVar();
    if (!open) return DialogAnswer::none;
    const DialogAnswer answer = contents(dialog, list, chosen);
    if (answer != DialogAnswer::none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return answer;
}

}  // namespace nacre::ui
