// The pictures of two sides, and what differs between them.
#pragma once

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/preview/preview.h"
#include "core/compare/comparison_model.h"
#include "core/compare/picture_difference.h"
#include "ui/compare_panel.h"

namespace nacre {

// What the preview shows beside the present design, and how.
struct CompareLook {
    ui::CompareView view = ui::CompareView::off;
    std::optional<int> alone = {};  // a side that is shown whole, whatever the view
    double divider = 0.5;
    DifferenceLook difference = {};
    std::array<std::string, 2> labels = {};

    bool compares() const { return alone || view != ui::CompareView::off; }
};

// Needs a current OpenGL 3.3 context from its beginning to its end. Side 0 is the left one.
class ComparedPictures {
  public:
    // From now on a side shows this; without a surface, the present design.
    void show(int side, const std::optional<ComparedSurface>& surface);

    // Draws what `look` needs; `now` is the present design. Factors get one scale.
    void draw(Preview& now, const Scene& scene, glm::ivec2 texels, int supersample, const CompareLook& look);

    // The same of what an environment lights, in parts; see Preview::begin().
    void begin(Preview& now, const Scene& scene, glm::ivec2 texels, int supersample, int goal,
               const CompareLook& look);
    void refine(Preview& now, double seconds, const CompareLook& look);
    SampleProgress progress(const Preview& now, const CompareLook& look) const;  // of the side that is behind

    // Puts the pictures into the current Dear ImGui window.
    void paint(const Preview& now, const CompareLook& look, ImVec2 corner, ImVec2 size) const;

    // Of the last difference that was drawn; nothing before the first.
    const std::optional<DifferenceNumbers>& numbers() const { return numbers_; }

  private:
    Preview& side(int index, Preview& now) { return own_[index] ? *sides_[index] : now; }
    const Preview& side(int index, const Preview& now) const { return own_[index] ? *sides_[index] : now; }
    std::vector<Preview*> shown(Preview& now, const CompareLook& look) const;
    void share_scale(Preview& now, const Scene& scene, const CompareLook& look);
    void draw_difference(Preview& now, const Scene& scene, glm::ivec2 texels, const DifferenceLook& look);

    std::unique_ptr<Preview> sides_[2];  // made when they are first needed
    bool own_[2] = {false, false};
    Texture difference_;
    std::optional<DifferenceNumbers> numbers_;
    Scene begun_scene_;  // of begin()
    glm::ivec2 begun_texels_{0};
};

}  // namespace nacre
