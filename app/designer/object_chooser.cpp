#include "app/designer/object_chooser.h"

#include <imgui.h>

#include "app/designer/scene_panel.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_tooltip =
    "A model of your own: a Wavefront OBJ file. It can also be dropped on the window.";

bool choice(const char* label, const char* tooltip, bool chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? ui::palette::accent_dim : ui::palette::window);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? ui::palette::accent_bright : ui::palette::text);
    const bool pressed = ui::button(label, tooltip);
    ImGui::PopStyleColor(2);
    return pressed;
}

}  // namespace

void ObjectChooser::draw(Scene& scene, const std::optional<DialogProgram>& dialogs) {
    if (auto made = shelf_.poll(); made && made->name == shelf_.wanted()) {
        scene.object = std::move(*made);
        if (!scene.object.note.empty())
            note_ = fs::path(scene.object.name).filename().string() + ": " + scene.object.note;
        if (!keep_camera_) reset_camera(scene);
    }
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetCursorPos({ImGui::GetCursorPosX() + gap, ImGui::GetCursorPosY() + gap});
    const bool own = names_object(shelf_.wanted()) && fs::path(shelf_.wanted()).has_extension();
    const std::string file_label =
        (own ? ui::as_label(fs::path(shelf_.wanted()).filename().string()) : "OBJ\u2026") + "##OBJ file";
    float needed = ui::button_width(file_label.c_str()) + 2 * gap;
    for (const ObjectKind* kind : object_kinds()) needed += ui::button_width(kind->label) + gap;
    if (needed > ImGui::GetContentRegionAvail().x)
        list(file_label, own, dialogs);
    else
        buttons(file_label, own, dialogs);
    if (shelf_.busy()) {
        ImGui::SameLine(0, gap);
        ImGui::AlignTextToFramePadding();
        ui::dim_text("\u2026");
    }
}

void ObjectChooser::buttons(const std::string& file_label, bool own,
                            const std::optional<DialogProgram>& dialogs) {
    for (const ObjectKind* kind : object_kinds()) {
        if (choice(kind->label, kind->about, shelf_.wanted() == kind->name)) want(kind->name);
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    if (choice(file_label.c_str(), file_tooltip, own)) ask_file(dialogs);
}

// Where the row is too narrow for buttons.
void ObjectChooser::list(const std::string& file_label, bool own,
                         const std::optional<DialogProgram>& dialogs) {
    std::string present(ui::visible_text(file_label));
    for (const ObjectKind* kind : object_kinds())
        if (shelf_.wanted() == kind->name) present = kind->label;
    ImGui::SetNextItemWidth(-ImGui::GetStyle().ItemSpacing.x - (shelf_.busy() ? ImGui::GetFontSize() : 0));
    const bool open = ImGui::BeginCombo("##object", present.c_str());
    ui::note_item("Object");
    ui::tooltip_for_item("What the light falls on.");
    if (!open) return;
    for (const ObjectKind* kind : object_kinds()) {
        if (ImGui::Selectable(kind->label, shelf_.wanted() == kind->name)) want(kind->name);
        ui::note_item(kind->label);
        ui::tooltip_for_item(kind->about);
    }
    if (ImGui::Selectable(file_label.c_str(), own)) ask_file(dialogs);
    ui::note_item(file_label);
    ui::tooltip_for_item(file_tooltip);
    ImGui::EndCombo();
}

void ObjectChooser::ask_file(const std::optional<DialogProgram>& dialogs) {
    chooser_.ask({.purpose = ui::FileDialog::Purpose::open,
                  .title = "Open object",
                  .folder = last_folder_,
                  .kind = "Wavefront OBJ",
                  .extensions = {".obj"}},
                 dialogs);
}

void ObjectChooser::talk() {
    if (!problem().empty()) {
        if (ui::question("Cannot open the object", problem(), {"OK"})) shelf_.forget_problem();
        return;
    }
    const auto answer = chooser_.draw();
    if (!answer || answer->chosen.empty()) return;
    last_folder_ = answer->chosen.parent_path();
    want(answer->chosen.string());
}

}  // namespace nacre
