#include "app/designer/object_chooser.h"

#include <imgui.h>

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
        chooser_.ask({.purpose = ui::FileDialog::Purpose::open,
                      .title = "Open object",
                      .folder = last_folder_,
                      .kind = "Wavefront OBJ",
                      .endings = {".obj"}},
                     dialogs);
    if (shelf_.busy()) {
        ImGui::SameLine(0, gap);
        ImGui::AlignTextToFramePadding();
        ui::dim_text("\u2026");
    }
}

void ObjectChooser::talk() {
    if (!problem().empty()) {
        if (ui::question("That did not work", problem(), {"OK"})) shelf_.forget_problem();
        return;
    }
    const auto answer = chooser_.draw();
    if (!answer || answer->chosen.empty()) return;
    last_folder_ = answer->chosen.parent_path();
    want(answer->chosen.string());
}

}  // namespace nacre
