#include "app/designer/imgui_session.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include "app/gl/gl.h"
#include "ui/missing_glyphs.h"
#include "ui/theme.h"

namespace nacre {

ImguiSession::ImguiSession(float ui_scale, float pixels_a_unit)
    : ui_scale_(ui_scale), pixels_a_unit_(pixels_a_unit) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // what is kept between runs is the program's decision
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ui::apply_theme(ui_scale, pixels_a_unit);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

ImguiSession::~ImguiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void ImguiSession::set_scale(float ui_scale, float pixels_a_unit) {
    if (ui_scale == ui_scale_ && pixels_a_unit == pixels_a_unit_) return;
    ui_scale_ = ui_scale;
    pixels_a_unit_ = pixels_a_unit;
    make_fonts();
}

void ImguiSession::make_fonts() {
    ui::apply_theme(ui_scale_, pixels_a_unit_, fallback_.fonts());
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void ImguiSession::new_frame() {
    const ImDrawData* shown = ImGui::GetDrawData();
    if (shown != nullptr && fallback_.find(ui::missing_characters(*shown))) make_fonts();
    ImGui_ImplOpenGL3_NewFrame();
}

void ImguiSession::draw(glm::ivec2 framebuffer) const {
    const ui::Colour& back = ui::palette::canvas;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, framebuffer.x, framebuffer.y);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(back.r, back.g, back.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace nacre
