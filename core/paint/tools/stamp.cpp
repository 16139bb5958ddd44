// Paint through a picture, once.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

// The tip's value at h: the picture lies on the sphere about the dab, angles from its middle as lengths, its
// upper edge where +y is when the pole is carried to the dab.
class Tip {
  public:
    explicit Tip(const Dab& dab)
        : raster_(*dab.tip),
          radius_(dab.radius()),
          to_pole_(glm::transpose(shortest_rotation({0, 0, 1}, dab.at))) {}

    double operator()(dvec3 h) const {
        const dvec3 l = to_pole_ * h;
        const double sine = std::hypot(l.x, l.y);
        const double angle = std::atan2(sine, l.z) / radius_;
        const dvec2 at = sine > 0 ? dvec2(l.x, l.y) * (angle / sine) : dvec2(0);
        if (std::max(std::abs(at.x), std::abs(at.y)) >= 1) return 0;
        return std::clamp(raster_value(raster_.values, raster_.width, at), 0.0, 1.0);
    }

  private:
    const Raster& raster_;
    double radius_;
    glm::dmat3 to_pole_;
};

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    if (dab.tip == nullptr) return;
    const Tip tip(dab);
    visit_images(
        raster.width, dab.symmetry, dab.at, dab.radius() * std::numbers::sqrt2,
        [&](const SeenTexel& texel) { scratch.add(texel.index, dab.brush.flow * tip(texel.original)); });
    scratch.pull(raster.values, [](std::size_t) { return 1.0; });
}

void icon(const IconPen& pen) {
    pen.disc({0.5f, 0.28f}, 0.14f);
    pen.fill({{0.44f, 0.38f}, {0.56f, 0.38f}, {0.60f, 0.60f}, {0.40f, 0.60f}});
    pen.fill({{0.20f, 0.58f}, {0.80f, 0.58f}, {0.80f, 0.71f}, {0.20f, 0.71f}});
    pen.line({{0.20f, 0.82f}, {0.80f, 0.82f}});
}

}  // namespace

const PaintToolInfo stamp_tool{
    .face = {.name = "Stamp",
             .key = 'T',
             .about = "Stamps a picture, as broad as the brush.",
             .more = "White paints. A picture that is dropped on the window can become one.",
             .icon = icon},
    .needs = ToolNeed::picture,
    .work = DabTool{.dab = dab, .follows_way = false}};

}  // namespace nacre
