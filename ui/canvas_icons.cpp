#include "ui/canvas_toolbar.h"

namespace nacre::ui {
namespace {

class IconPenOnScreen final : public IconPen {
  public:
    IconPenOnScreen(ImVec2 corner, float side, ImU32 colour)
        : corner_(corner), side_(side), colour_(colour) {}

    void line(std::span<const glm::vec2> points, bool closed) const override {
        for (const glm::vec2& point : points) list_.PathLineTo(at(point));
        list_.PathStroke(colour_, closed ? ImDrawFlags_Closed : 0, side_ * 0.075f);
    }
    void fill(std::span<const glm::vec2> convex) const override {
        for (const glm::vec2& point : convex) list_.PathLineTo(at(point));
        list_.PathFillConvex(colour_);
    }
    void circle(glm::vec2 middle, float radius) const override {
        list_.AddCircle(at(middle), radius * side_, colour_, 0, side_ * 0.075f);
    }
    void disc(glm::vec2 middle, float radius) const override {
        list_.AddCircleFilled(at(middle), radius * side_, colour_);
    }

  private:
    ImVec2 at(glm::vec2 point) const { return {corner_.x + point.x * side_, corner_.y + point.y * side_}; }

    ImDrawList& list_ = *ImGui::GetWindowDrawList();
    ImVec2 corner_;
    float side_;
    ImU32 colour_;
};

}  // namespace

void draw_tool_icon(const ToolFace& face, ImVec2 corner, float side, ImU32 colour) {
    face.icon(IconPenOnScreen(corner, side, colour));
}

}  // namespace nacre::ui
