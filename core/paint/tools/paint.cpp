// Paint as the brush has it.
#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    cover(raster, dab, scratch);
    scratch.paint(raster.values, dab.brush);
}

void icon(const IconPen& pen) {
    pen.line({{0.82f, 0.16f}, {0.48f, 0.54f}});
    pen.disc({0.37f, 0.65f}, 0.13f);
    pen.fill({{0.26f, 0.58f}, {0.45f, 0.75f}, {0.16f, 0.84f}});
}

}  // namespace

const PaintToolInfo paint_tool{
    .face = {.name = "Paint",
             .key = 'B',
             .about = "Adds facets, here or on the object.",
             .more = "Facets tilted up shine below the highlight's middle, those tilted left to the "
                     "right of it: on the object the brush paints where you see it. On a lobe that is not "
                     "painted a new painted layer begins.",
             .icon = icon,
             .begins_group = true},
    .work = DabTool{.dab = dab}};

}  // namespace nacre
