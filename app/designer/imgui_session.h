// A Dear ImGui context with Nacre's theme and its OpenGL renderer, as both hosts need it.
#pragma once

#include <glm/vec2.hpp>

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

    void new_frame() const;

    // Draws what ImGui::Render() made into framebuffer 0 of this size.
    void draw(glm::ivec2 framebuffer) const;

  private:
    float ui_scale_, pixels_a_unit_;
};

}  // namespace nacre
