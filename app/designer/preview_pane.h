// The picture in the middle of the window, and what the mouse does on it.
#pragma once

#include <glm/vec2.hpp>
#include <memory>

#include "app/designer/draw_quality.h"
#include "app/preview/preview.h"
#include "app/preview/scene.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class PreviewPane {
  public:
    void show(std::shared_ptr<const Tables> tables);

    // Fills the current Dear ImGui window. Left drag moves the light, right or middle drag orbits, the
    // wheel zooms. Draws anew only what changed.
    void draw(Scene& scene);

    // From now on each picture is drawn as finely as can be, however long it takes.
    void insist_on_best() { insist_on_best_ = true; }

    bool has_picture() const { return !preview_.empty(); }

  private:
    void redraw_if_needed(const Scene& scene, glm::ivec2 size);
    void redraw(const Scene& scene, glm::ivec2 size, DrawQuality quality);

    Preview preview_;
    bool insist_on_best_ = false;
    bool stale_ = true;
    Scene drawn_scene_;
    glm::ivec2 drawn_size_{0};
    DrawQuality drawn_quality_;
    double changed_at_ = 0;  // seconds on Dear ImGui's clock
    double seconds_a_sample_ = 0;
};

}  // namespace nacre
