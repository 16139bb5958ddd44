#include "ui/stamp_picture.h"

#include <algorithm>
#include <array>

#include "core/paint/raster_texels.h"

namespace nacre::ui {
namespace {

constexpr int cells = thumbnail_side;  // of the mesh, each way

glm::dvec2 corner_at(int row, int column) { return {2.0 * column / cells - 1, 1 - 2.0 * row / cells}; }

}  // namespace

void draw_stamp(const Raster& thumbnail, const StampPlace& place, ImVec4 colour) {
    struct Corner {
        std::optional<ImVec2> at;
        ImU32 colour;
    };
    std::array<std::array<Corner, cells + 1>, cells + 1> corners;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const glm::dvec2 at = corner_at(row, column);
            const double value = raster_value(thumbnail.values, thumbnail.width, at);
            const auto paints = static_cast<float>(std::clamp(value, 0.0, 1.0));
            corners[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = {
                place(at), ImGui::GetColorU32({colour.x, colour.y, colour.z, colour.w * paints})};
        }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    for (std::size_t row = 0; row < cells; ++row)
        for (std::size_t column = 0; column < cells; ++column) {
            const std::array<Corner, 4> quad{corners[row][column], corners[row][column + 1],
                                             corners[row + 1][column + 1], corners[row + 1][column]};
            const bool empty = std::all_of(quad.begin(), quad.end(),
                                           [](const Corner& c) { return (c.colour & IM_COL32_A_MASK) == 0; });
            if (empty || !std::all_of(quad.begin(), quad.end(), [](const Corner& c) { return c.at; }))
                continue;
            list.PrimReserve(6, 4);
            const unsigned first = list._VtxCurrentIdx;
            for (const unsigned i : {0u, 1u, 2u, 0u, 2u, 3u})
                list.PrimWriteIdx(static_cast<ImDrawIdx>(first + i));
            for (const Corner& corner : quad) list.PrimWriteVtx(*corner.at, uv, corner.colour);
        }
}

void draw_stamp(const Raster& thumbnail, ImVec2 corner, float side, ImVec4 colour) {
    const auto place = [=](glm::dvec2 at) {
        const glm::vec2 part((at.x + 1) / 2, (1 - at.y) / 2);
        return std::optional(ImVec2(corner.x + part.x * side, corner.y + part.y * side));
    };
    draw_stamp(thumbnail, place, colour);
}

}  // namespace nacre::ui
