// The connected area whose values are like the one that is pointed at.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

constexpr float edge = 0.5f;  // of a texel beside the area, so that no seam stays along a soft edge

class Flood {
  public:
    Flood(const Raster& raster, const PressedArea& area)
        : raster_(raster), area_(area), side_(raster.width) {}

    // How much of each texel is covered from there.
    std::vector<float> from(dvec3 at) const {
        const glm::dvec2 point = disk_point(at);
        const int row = cell((1 - point.y) / 2), column = cell((point.x + 1) / 2);
        std::vector<float> amounts(raster_.values.size());
        if (!is_open(row, column)) return amounts;
        const auto like = static_cast<double>(raster_.values[index(row, column)]);
        std::vector<std::pair<int, int>> waiting{{row, column}};
        amounts[index(row, column)] = 1;
        while (!waiting.empty()) {
            const auto [i, j] = waiting.back();
            waiting.pop_back();
            for (const auto& [r, c] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
                if (!is_open(r, c) || amounts[index(r, c)] == 1) continue;
                const double off = std::abs(static_cast<double>(raster_.values[index(r, c)]) - like);
                if (off > area_.tolerance) {
                    amounts[index(r, c)] = edge;
                    continue;
                }
                amounts[index(r, c)] = 1;
                waiting.emplace_back(r, c);
            }
        }
        return amounts;
    }

  private:
    int cell(double along) const {
        return std::clamp(static_cast<int>(std::floor(along * side_)), 0, side_ - 1);
    }
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(column);
    }
    // The area does not go through what is not selected.
    bool is_open(int row, int column) const {
        if (row < 0 || column < 0 || row >= side_ || column >= side_) return false;
        if (!is_painted(side_, texel_point(side_, row, column))) return false;
        return area_.selected == nullptr || (*area_.selected)[index(row, column)] > 0;
    }

    const Raster& raster_;
    const PressedArea& area_;
    int side_;
};

void cover(const Raster& raster, const PressedArea& area, Coverage& coverage) {
    const Flood flood(raster, area);
    if (area.symmetry.kind == SymmetryKind::ring) {
        const std::vector<float> amounts = flood.from(area.at);
        visit_images(raster.width, area.symmetry, area.at, 4, [&](const SeenTexel& texel) {
            coverage.add(texel.index, raster_value(amounts, raster.width, disk_point(texel.original)));
        });
        return;
    }
    for (const glm::dmat3& image : symmetry_images(area.symmetry)) {
        const std::vector<float> amounts = flood.from(image * area.at);
        for (std::size_t i = 0; i < amounts.size(); ++i) coverage.add(i, static_cast<double>(amounts[i]));
    }
}

void icon(const IconPen& pen) {
    pen.line({{0.42f, 0.18f}, {0.76f, 0.50f}, {0.44f, 0.80f}, {0.14f, 0.50f}}, true);
    pen.fill({{0.18f, 0.52f}, {0.72f, 0.52f}, {0.44f, 0.76f}});
    pen.disc({0.84f, 0.72f}, 0.08f);
}

}  // namespace

const PaintToolInfo fill_tool{
    .face =
        {.name = "Fill",
         .key = 'F',
         .about = "Fills an area of like values with a click.",
         .more =
             "The area is connected to where you click, and ends at the selection. The tolerance says how "
             "much its values may differ.",
         .icon = icon,
         .begins_group = true},
    .needs = ToolNeed::tolerance,
    .work = AreaTool{.cover = cover}};

}  // namespace nacre
