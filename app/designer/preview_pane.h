// The picture in the middle of the window, and what the mouse does on it.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "app/designer/compared_pictures.h"
#include "app/designer/draw_quality.h"
#include "app/preview/preview.h"
#include "app/preview/probe.h"
#include "app/preview/render.h"
#include "app/preview/scene.h"
#include "ui/brush_surface.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class PreviewPane {
  public:
    // What stands at a side of a comparison (0: left); without a surface, the present design.
    void show_side(int side, const std::optional<ComparedSurface>& surface);

    // How the next picture compares; its divider follows the hand that drags it.
    CompareLook look;
    const std::optional<DifferenceNumbers>& difference() const { return compared_.numbers(); }

    // Fills the current Dear ImGui window. Returns what the pointer on the object means to a tool; nothing
    // where the window has no room or Shift keeps the tools away.
    std::optional<ui::BrushSurface> point(const Scene& scene);

    // To be called after point(). Left drag moves the light, unless a tool has taken what the pointer does;
    // right or middle drag orbits, the wheel zooms.
    void work(Scene& scene, bool taken);

    // Draws into the window, redrawing only what changed, with a veil of light over it.
    void draw(const std::shared_ptr<const Tables>& tables, const Scene& scene, const Veil& veil);

    // The normal of the facets that light the pixel under the pointer.
    const std::optional<glm::dvec3>& pointed_at() const { return pointed_at_; }

    // From now on each picture is drawn as finely as can be, however long it takes.
    void insist_on_best() { insist_on_best_ = true; }

    // As it is shown, in another size: sRGB in [0, 1], or linear radiance. Only where there is a picture.
    RenderedImage picture(const Scene& scene, glm::ivec2 size, bool linear);
    glm::ivec2 size() const { return drawn_size_; }  // pixels

    bool has_picture() const { return !preview_.empty(); }

    // The picture still accumulates samples of its environment: it differs from frame to frame.
    bool accumulating() const {
        const SampleProgress progress = compared_.progress(preview_, look);
        return progress.samples < progress.goal;
    }

    // What lies under the pixels of a picture of this size.
    const SurfaceImage& surface(const Scene& scene, glm::ivec2 size) { return preview_.surface(scene, size); }

  private:
    std::optional<glm::dvec3> normal_at(const Scene& scene, glm::dvec2 pixel);
    void draw_marks(const Scene& scene);
    void draw_glow(const Scene& scene, const Veil& veil);
    void redraw_if_needed(const Scene& scene, glm::ivec2 size);
    enum class Pace { moving, resting, insisting };

    void redraw(const Scene& scene, glm::ivec2 size, DrawQuality quality, Pace pace);
    void measured_draw(const Scene& scene, glm::ivec2 texels, int supersample);
    void accumulate(const Scene& scene, glm::ivec2 texels, int supersample, Pace pace);
    void draw_progress() const;

    Preview preview_;
    std::shared_ptr<const Tables> shown_;  // by preview_
    ComparedPictures compared_;
    Texture glow_;
    ImVec2 corner_{0, 0}, size_{0, 0};  // of the picture in this frame
    std::optional<glm::dvec3> pointed_at_;
    bool tool_works_ = false;  // the held button is the tool's
    bool insist_on_best_ = false;
    bool stale_ = true;
    Scene drawn_scene_;
    ui::CompareView drawn_view_ = ui::CompareView::off;
    std::optional<int> drawn_alone_;
    DifferenceLook drawn_difference_;
    glm::ivec2 drawn_size_{0};
    DrawQuality drawn_quality_;
    Pace drawn_pace_ = Pace::moving;
    Motion last_motion_ = Motion::none;
    double changed_at_ = 0;  // seconds on Dear ImGui's clock
    double seconds_a_sample_ = 0;
};

}  // namespace nacre
