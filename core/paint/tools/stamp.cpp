// Paint through a picture, once.
#include <numbers>

#include "core/paint/paint_tool.h"
#include "core/paint/tip.h"

namespace nacre {
namespace {

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    if (dab.tip == nullptr) return;
    const Tip tip(dab);
    visit_images(
        raster.width, dab.symmetry, dab.at, dab.radius() * std::numbers::sqrt2,
        [&](const SeenTexel& texel) { scratch.add(texel.index, dab.brush.flow * tip(texel.original)); });
    scratch.paint(raster.values, dab.brush);
}

void icon(const IconPen& pen) {
    pen.disc({0.5f, 0.28f}, 0.14f);
    pen.fill({{0.44f, 0.38f}, {0.56f, 0.38f}, {0.60f, 0.60f}, {0.40f, 0.60f}});
    pen.fill({{0.20f, 0.58f}, {0.80f, 0.58f}, {0.80f, 0.71f}, {0.20f, 0.71f}});
    pen.line({{0.20f, 0.82f}, {0.80f, 0.82f}});
}

}  // namespace

const PaintToolInfo stamp_tool{
    .face =
        {.name = "Stamp",
         .key = 'T',
         .about = "Stamps a picture, as wide as the brush.",
         .more =
             "It shines the way up that it is shown. White paints. A picture that is dropped on the window "
             "can become one.",
         .icon = icon},
    .needs = ToolNeed::picture,
    .work = DabTool{.dab = dab, .follows_way = false}};

}  // namespace nacre
