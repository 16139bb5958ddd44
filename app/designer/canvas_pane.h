// The canvas and its picture, which is p of the design as it is in this frame: no bake stands between.
#pragma once

#include "app/designer/frame.h"
#include "app/preview/gl_objects.h"
#include "app/preview/scene.h"
#include "core/design/design.h"
#include "ui/hemisphere_canvas.h"
#include "ui/layers_panel.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class CanvasPane {
  public:
    ui::CanvasState state;

    // Fills the current Dear ImGui window, where the tools work on `design`. `seen`: what is on the screen.
    void work(const Frame& seen, Design& design, ui::LayersView& layers);

    // Makes the picture, as work() left the camera: of p, or of what p shines like under the main light; and
    // of the chosen layer's mask while that is painted.
    void update(const Frame& frame, const Scene& scene, std::size_t chosen);

    // Draws it into the window, once work() and update() are done. `marked` is a normal that the preview
    // points at.
    void draw(const Frame& frame, const Design& design, const ui::LayersView& layers,
              const std::optional<dvec3>& marked) const;

    // From now on each picture is drawn with every pixel, however long it takes.
    void insist_on_best() { insist_on_best_ = true; }

    // Texels of the newest picture.
    glm::ivec2 picture_size() const { return texels_; }

    // Whether a place on the screen is the canvas', or its toolbar's or legend's.
    bool holds(ImVec2 at) const;

    // The normal under the pointer.
    const std::optional<dvec3>& pointed_at() const { return frame_.cursor; }

  private:
    // Everything that the picture depends on.
    struct Drawn {
        int revision = -1;
        HemisphereCamera camera;
        glm::dvec2 size{0};  // pixels of the framebuffer
        ScaleKind scale = ScaleKind::perceptual;
        std::shared_ptr<const Tables> tables = nullptr;  // that it shines by; null: p
        glm::dvec3 light{0};                             // irradiance times exposure
        int divisor = 0;
        std::shared_ptr<const Raster> mask = {};  // over the picture; null: none
        glm::dmat3 mask_frame{1};
        bool operator==(const Drawn&) const = default;
    };

    void show_below(const Frame& seen);
    HemisphereView view() const;  // of the framebuffer's pixels
    int divisor(const Drawn& wanted);
    void redraw(const FacetDistribution* p, const HemisphereView& view, const Drawn& wanted);

    ImVec2 corner_, extent_;    // of the window that it fills
    int scaled_revision_ = -1;  // that scale_ is for
    DensityScale scale_;
    ui::CanvasFrame frame_{.low = {}, .high = {}, .view = HemisphereView({}, {1, 1}), .cursor = {}};
    Texture picture_;
    glm::ivec2 texels_{0};
    Drawn drawn_;
    double changed_at_ = 0;  // seconds on Dear ImGui's clock
    bool insist_on_best_ = false;
};

}  // namespace nacre
