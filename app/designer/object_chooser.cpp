#include "app/designer/object_chooser.h"

#include <imgui.h>

#include "app/designer/folder.h"
#include "app/designer/scene_panel.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

struct Entry {
    const char* name;  // see make_object()
    const char* label;
    const char* tooltip;
};

constexpr Entry entries[] = {
    {"sphere", "Sphere", "Every direction once. The grain runs around its axis."},
    {"torus", "Torus", "Curved both ways, like a saddle inside. The grain runs around the ring."},
    {"plate", "Plate", "A tile, a little domed, with round edges. The grain runs from left to right."},
    {"tablecloth", "Tablecloth", "A cloth that has fallen over a round table. The grain is its weave."},
};

ui::Listing list_obj_files(const fs::path& folder) { return list_folder(folder, {".obj"}); }

bool choice(const char* label, const char* tooltip, bool chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? ui::palette::accent_dim : ui::palette::window);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? ui::palette::accent_bright : ui::palette::text);
    const bool pressed = ui::button(label, tooltip);
    ImGui::PopStyleColor(2);
    return pressed;
}

}  // namespace

void ObjectChooser::draw(Scene& scene) {
    if (auto made = shelf_.poll(); made && made->name == shelf_.wanted()) {
        scene.object = std::move(*made);
        reset_camera(scene);
    }
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetCursorPos({ImGui::GetCursorPosX() + gap, ImGui::GetCursorPosY() + gap});
    for (const Entry& entry : entries) {
        if (choice(entry.label, entry.tooltip, shelf_.wanted() == entry.name)) want(entry.name);
        ImGui::SameLine(0, gap);
    }
    const bool file = names_object(shelf_.wanted()) && fs::path(shelf_.wanted()).has_extension();
    const std::string label =
        (file ? fs::path(shelf_.wanted()).filename().string() : "OBJ\u2026") + "##OBJ file";
    if (choice(label.c_str(),
               "A model of your own: a Wavefront OBJ file. It can also be dropped on the window.", file))
        dialog_ = ui::FileDialog{.purpose = ui::FileDialog::Purpose::open,
                                 .listing = list_obj_files(last_folder_),
                                 .path = {},
                                 .problem = {},
                                 .title = "Open object",
                                 .hint = "name or path of an .obj file"};
    if (shelf_.busy()) {
        ImGui::SameLine(0, gap);
        ImGui::AlignTextToFramePadding();
        ui::dim_text("\u2026");
    }
}

void ObjectChooser::talk() {
    if (!shelf_.problem().empty()) {
        if (ui::question("That did not work", shelf_.problem(), {"OK"})) shelf_.forget_problem();
        return;
    }
    if (!dialog_) return;
    fs::path chosen;
    const ui::DialogAnswer answer = ui::file_dialog(*dialog_, list_obj_files, chosen);
    if (answer == ui::DialogAnswer::none) return;
    dialog_.reset();
    if (answer != ui::DialogAnswer::accepted) return;
    last_folder_ = chosen.parent_path();
    want(chosen.string());
}

}  // namespace nacre
