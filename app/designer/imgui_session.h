// A Dear ImGui context with Nacre's theme and its OpenGL renderer, as both hosts need it.
#pragma once

#include <glm/vec2.hpp>

namespace nacre {

class ImguiSession {
  public:
    // `ui_scale` is 1 at 96 dots per inch. A current OpenGL 3.3 context is needed, then and in every later
    // call.
    explicit ImguiSession(float ui_scale);
    ~ImguiSession();
    ImguiSession(const ImguiSession&) = delete;
    ImguiSession& operator=(const ImguiSession&) = delete;

    // Between frames: style and fonts for another monitor. Nothing happens where the scale stays.
    void set_scale(float ui_scale);

    void new_frame() const;

    // Draws what ImGui::Render() made into framebuffer 0 of this size.
    void draw(glm::ivec2 framebuffer) const;

  private:
    float ui_scale_;
};

}  // namespace nacre
