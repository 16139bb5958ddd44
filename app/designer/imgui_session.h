// A Dear ImGui context with Nacre's theme and its OpenGL renderer, as both hosts need it.
#pragma once

#include <glm/vec2.hpp>

#include "app/designer/fallback_fonts.h"

namespace nacre {

class ImguiSession {
  public:
    // A current OpenGL 3.3 context is needed, then and in every later call. See ui::apply_theme().
    explicit ImguiSession(float ui_scale, float pixels_a_unit = 1);
    ~ImguiSession();
    ImguiSession(const ImguiSession&) = delete;
    ImguiSession& operator=(const ImguiSession&) = delete;

    // Between frames: style and fonts for another monitor. Nothing happens where the scale stays.
    void set_scale(float ui_scale, float pixels_a_unit);

    // Before ImGui::NewFrame. Characters that the last frame showed and no font had so far get theirs.
    void new_frame();

    // Draws what ImGui::Render() made into framebuffer 0 of this size.
    void draw(glm::ivec2 framebuffer) const;

  private:
    void make_fonts();

    float ui_scale_, pixels_a_unit_;
    FallbackFonts fallback_;
};

}  // namespace nacre
