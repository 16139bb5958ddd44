#include "ui/export_dialog.h"

#include <imgui.h>

#include "ui/escape.h"
#include "ui/keys.h"
#include "ui/list_row.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double pixels_max = 2048;  // a side: four samples a pixel are drawn at once

void format_list(ExportDialog& dialog) {
    for (std::size_t i = 0; i < dialog.formats.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const ExportChoice& format = dialog.formats[i];
        if (list_row(("Format " + format.title).c_str(),
                     {.text = format.title, .at_right = {}, .chosen = i == dialog.chosen}))
            dialog.chosen = i;
        ImGui::PopID();
    }
}

void pixel_row(const char* label, double& pixels) {
    slider({.label = label,
            .low = 64,
            .high = pixels_max,
            .least = 16,
            .most = pixels_max,
            .reset = 1024,
            .format = "%.0f px",
            .logarithmic = false,
            .tooltip =
                "Pixels of the picture, each the mean of four samples. nacre-cli render makes larger ones.",
            .whole = true},
           pixels);
}

void options(ExportDialog& dialog) {
    if (dialog.formats[dialog.chosen].is_picture) {
        pixel_row("Width", dialog.width);
        pixel_row("Height", dialog.height);
        return;
    }
    slider({.label = "Error tolerance",
            .low = 1e-4,
            .high = 1e-2,
            .least = 1e-5,
            .most = 0.1,
            .reset = 1e-3,
            .format = "%.1e",
            .logarithmic = true,
            .tooltip =
                "The error that the tables are made for: the relative error of the projected area g, and the "
                "error of the albedo R as a fraction of the incident light. Smaller errors need larger "
                "tables; all "
                "of them together take at most 64 KiB, or 256 KiB where that does not suffice."},
           dialog.tolerance);
    if (dialog.formats[dialog.chosen].has_error)
        slider(
            {.label = "Misplaced light",
             .low = 1e-3,
             .high = 0.1,
             .least = 1e-4,
             .most = 1,
             .reset = 0.01,
             .format = "%.1e",
             .logarithmic = true,
             .tooltip =
                 "The part of the light that may leave another way than the design sends it. The file is the "
                 "smallest that keeps to it, or the largest that the format allows; what was reached is "
                 "told."},
            dialog.error);
    else if (dialog.formats[dialog.chosen].has_names)
        text_field(
            "Prefix", dialog.prefix, "",
            "The prefix of the names in the file. Designs with different prefixes fit into one shader.");
    else
        ImGui::Dummy(ImVec2(0, ImGui::GetFrameHeight()));  // as high as the two rows of a picture
}

}  // namespace

DialogAnswer export_dialog(ExportDialog& dialog) {
    if (!begin_dialog("Export", 30)) return DialogAnswer::none;
    format_list(dialog);
    ImGui::Spacing();
    const ExportChoice& format = dialog.formats[dialog.chosen];
    const bool named = !format.has_names || dialog.prefix_problem.empty();
    const bool sound = named && !format.refuses;
    const std::string reason = named ? format.holds : "The prefix " + dialog.prefix_problem + ".";
    const float size = ImGui::GetFontSize();
    ImGui::BeginChild("about", ImVec2(0, 5.2f * size));
    dim_text(named ? format.about : reason);
    if (named && !format.holds.empty()) dim_text(format.holds);
    ImGui::EndChild();
    options(dialog);
    ImGui::Spacing();
    const float width = size * 7.5f;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * width - ImGui::GetStyle().ItemSpacing.x);
    ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
    DialogAnswer answer = DialogAnswer::none;
    if (button("Choose file\u2026##Choose export file", sound ? "Destination." : reason.c_str(), sound,
               width))
        answer = DialogAnswer::accepted;
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (button("Cancel", nullptr, true, width)) answer = DialogAnswer::cancelled;
    if (sound && !ImGui::GetIO().WantTextInput && is_key_pressed(key::enter, false))
        answer = DialogAnswer::accepted;
    if (take_escape()) answer = DialogAnswer::cancelled;
    end_dialog(answer != DialogAnswer::none);
    return answer;
}

bool progress_dialog(const char* title, const std::string& text, double done) {
    if (!begin_dialog(title, 28)) return false;
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::ProgressBar(static_cast<float>(done), ImVec2(-FLT_MIN, 0));
    ImGui::Spacing();
    const float width = ImGui::GetFontSize() * 7;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    const bool stopped =
        button("Stop##Stop export", "Nothing is written then.", true, width) || take_escape();
    end_dialog(false);
    return stopped;
}

}  // namespace nacre::ui
