// The canvas and its picture, which is p of the design as it is in this frame: no bake stands between.
#pragma once

#include <functional>

#include "app/preview/gl_objects.h"
#include "core/design/design.h"
#include "core/model/live_distribution.h"
#include "ui/hemisphere_canvas.h"
#include "ui/layers_panel.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class CanvasPane {
  public:
    ui::CanvasState state;

    // Fills the current Dear ImGui window. `layers` says which of them is chosen, and which are shown.
    // `edited` is called once the tools have done their part, before p is drawn.
    void draw(Design& design, ui::LayersView& layers, const std::function<void()>& edited);

    // p as the canvas showed it last, and a number that rises whenever it changes.
    const FacetDistribution* distribution() const { return live_.newest(); }
    int revision() const { return live_.revision(); }

    // From now on each picture is drawn with every pixel, however long it takes.
    void insist_on_best() { insist_on_best_ = true; }

    // The normal under the pointer.
    const std::optional<dvec3>& pointed_at() const { return pointed_at_; }

  private:
    // Everything that the picture depends on.
    struct Drawn {
        int revision = -1;
        HemisphereCamera camera;
        glm::dvec2 size{0};
        bool logarithmic = false;
        int divisor = 0;
        bool operator==(const Drawn&) const = default;
    };

    std::optional<std::size_t> strongest_layer(dvec3 h) const;
    void show_below(const Distribution& distribution);
    int divisor(const Drawn& wanted);
    void redraw(const FacetDistribution& p, const HemisphereView& view, const Drawn& wanted);

    LiveDistribution live_;
    int scaled_revision_ = -1;  // that scale_ is for
    DensityScale scale_;
    std::optional<dvec3> pointed_at_;
    Texture picture_;
    glm::ivec2 texels_{0};
    Drawn drawn_;
    double changed_at_ = 0;  // seconds on Dear ImGui's clock
    bool insist_on_best_ = false;
};

}  // namespace nacre
