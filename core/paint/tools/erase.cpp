// Toward 0.
#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

constexpr double erased = 1e-4;  // what falls below is none

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    cover(raster, dab, scratch);
    const std::vector<std::size_t> touched = scratch.touched();
    scratch.pull(raster.values, [](std::size_t) { return 0.0; });
    for (const std::size_t index : touched)
        if (static_cast<double>(raster.values[index]) < erased) raster.values[index] = 0;
}

void icon(const IconPen& pen) {
    pen.line({{0.54f, 0.18f}, {0.84f, 0.44f}, {0.48f, 0.80f}, {0.18f, 0.54f}}, true);
    pen.line({{0.34f, 0.38f}, {0.66f, 0.64f}});
}

}  // namespace

const PaintToolInfo erase_tool{.face = {.name = "Erase",
                                        .key = 'E',
                                        .about = "Takes facets away.",
                                        .more = "What is left keeps its ratios.",
                                        .icon = icon},
                               .work = DabTool{.dab = dab}};

}  // namespace nacre
