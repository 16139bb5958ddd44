// Plots drawn into the current Dear ImGui window.
#pragma once

#include <imgui.h>

#include "core/plot/plot_pen.h"

namespace nacre::ui {

class PlotPenOnScreen final : public PlotPen {
  public:
    // `picture` holds the pixels of a slice, null where there is none.
    explicit PlotPenOnScreen(ImTextureID picture);

    double em() const override;
    double text_width(const std::string& text) const override;
    void text(glm::dvec2 left_middle, const std::string& text, Ink ink) override;
    void line(std::span<const glm::dvec2> points, Ink ink, double width) override;
    void disc(glm::dvec2 middle, double radius, Ink ink) override;
    void mesh(std::span<const glm::dvec2> corners, std::span<const glm::u8vec3> colours,
              std::span<const Cell> cells) override;
    void picture(const PlotBox& box, const SlicePlot& slice) override;

  private:
    ImDrawList& list_;
    ImTextureID picture_;
    float size_;
};

}  // namespace nacre::ui
