// Toward a half.
#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    cover(raster, dab, scratch);
    scratch.pull(raster.values, [](std::size_t) { return 0.5; });
}

void icon(const IconPen& pen) {
    pen.circle({0.5f, 0.5f}, 0.3f);
    pen.line({{0.5f, 0.2f}, {0.5f, 0.8f}});
}

}  // namespace

const PaintToolInfo half_tool{.face = {.name = "Half",
                                       .key = 'H',
                                       .about = "Half of the paint.",
                                       .more = "Neither full nor none.",
                                       .icon = icon},
                              .work = DabTool{.dab = dab}};

}  // namespace nacre
