#include <cmath>
#include <numbers>
#include <vector>

#include "ui/canvas_toolbar.h"

namespace nacre::ui {
namespace {

// Draws in a unit square, y downward.
class IconPen {
  public:
    IconPen(ImVec2 corner, float side, ImU32 colour) : corner_(corner), side_(side), colour_(colour) {}

    void line(const std::vector<ImVec2>& points, bool closed = false) const {
        for (const ImVec2& point : points) list_.PathLineTo(at(point));
        list_.PathStroke(colour_, closed ? ImDrawFlags_Closed : 0, side_ * 0.075f);
    }
    void fill(const std::vector<ImVec2>& points) const {
        for (const ImVec2& point : points) list_.PathLineTo(at(point));
        list_.PathFillConvex(colour_);
    }
    void circle(ImVec2 middle, float radius) const {
        list_.AddCircle(at(middle), radius * side_, colour_, 0, side_ * 0.075f);
    }
    void disc(ImVec2 middle, float radius) const {
        list_.AddCircleFilled(at(middle), radius * side_, colour_);
    }

  private:
    ImVec2 at(ImVec2 point) const { return {corner_.x + point.x * side_, corner_.y + point.y * side_}; }

    ImDrawList& list_ = *ImGui::GetWindowDrawList();
    ImVec2 corner_;
    float side_;
    ImU32 colour_;
};

void star(const IconPen& pen) {
    for (int ray = 0; ray < 5; ++ray) {
        const float turn = static_cast<float>(2 * std::numbers::pi * ray / 5);
        const float x = std::sin(turn), y = -std::cos(turn);
        pen.fill({{0.5f + 0.36f * x, 0.5f + 0.36f * y},
                  {0.5f - 0.07f * y, 0.5f + 0.07f * x},
                  {0.5f + 0.07f * y, 0.5f - 0.07f * x}});
    }
}

}  // namespace

void draw_tool_icon(CanvasTool tool, ImVec2 corner, float side, ImU32 colour) {
    const IconPen pen(corner, side, colour);
    switch (tool) {
        case CanvasTool::handles:
            pen.fill({{0.30f, 0.15f}, {0.30f, 0.72f}, {0.46f, 0.58f}});
            pen.fill({{0.30f, 0.15f}, {0.46f, 0.58f}, {0.72f, 0.56f}});
            pen.line({{0.44f, 0.54f}, {0.57f, 0.84f}});
            break;
        case CanvasTool::grab:
            pen.line({{0.5f, 0.14f}, {0.5f, 0.86f}});
            pen.line({{0.14f, 0.5f}, {0.86f, 0.5f}});
            pen.line({{0.40f, 0.24f}, {0.5f, 0.13f}, {0.60f, 0.24f}});
            pen.line({{0.40f, 0.76f}, {0.5f, 0.87f}, {0.60f, 0.76f}});
            pen.line({{0.24f, 0.40f}, {0.13f, 0.5f}, {0.24f, 0.60f}});
            pen.line({{0.76f, 0.40f}, {0.87f, 0.5f}, {0.76f, 0.60f}});
            break;
        case CanvasTool::paint:
            pen.line({{0.82f, 0.16f}, {0.48f, 0.54f}});
            pen.disc({0.37f, 0.65f}, 0.13f);
            pen.fill({{0.26f, 0.58f}, {0.45f, 0.75f}, {0.16f, 0.84f}});
            break;
        case CanvasTool::erase:
            pen.line({{0.54f, 0.18f}, {0.84f, 0.44f}, {0.48f, 0.80f}, {0.18f, 0.54f}}, true);
            pen.line({{0.34f, 0.38f}, {0.66f, 0.64f}});
            break;
        case CanvasTool::smooth:
            pen.disc({0.5f, 0.5f}, 0.11f);
            pen.circle({0.5f, 0.5f}, 0.23f);
            pen.circle({0.5f, 0.5f}, 0.37f);
            break;
        case CanvasTool::smear:
            pen.line({{0.14f, 0.66f},
                      {0.27f, 0.46f},
                      {0.40f, 0.46f},
                      {0.52f, 0.62f},
                      {0.64f, 0.62f},
                      {0.82f, 0.32f}});
            pen.line({{0.64f, 0.30f}, {0.84f, 0.28f}, {0.86f, 0.48f}});
            break;
        case CanvasTool::stamp:
            pen.disc({0.5f, 0.28f}, 0.14f);
            pen.fill({{0.44f, 0.38f}, {0.56f, 0.38f}, {0.60f, 0.60f}, {0.40f, 0.60f}});
            pen.fill({{0.20f, 0.58f}, {0.80f, 0.58f}, {0.80f, 0.71f}, {0.20f, 0.71f}});
            pen.line({{0.20f, 0.82f}, {0.80f, 0.82f}});
            break;
        case CanvasTool::line:
            pen.line({{0.20f, 0.80f}, {0.80f, 0.20f}});
            break;
        case CanvasTool::ring:
            pen.circle({0.5f, 0.5f}, 0.31f);
            break;
        case CanvasTool::star:
            star(pen);
            break;
    }
}

}  // namespace nacre::ui
