#include "core/paint/selection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/paint/contour.h"
#include "core/paint/polygon_cover.h"
#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

constexpr int cells = 1024;  // a side
constexpr double radius = std::numbers::sqrt2;
constexpr double least = 0.5;  // that some place is selected, else nothing is

dvec2 cell_point(int row, int column) { return radius * texel_point(cells, row, column); }

std::size_t cell_index(int row, int column) {
    return static_cast<std::size_t>(row) * cells + static_cast<std::size_t>(column);
}

// How much of a cell lies on a disk about the middle.
double share_within(double disk, dvec2 at) {
    return std::clamp(0.5 + (disk - glm::length(at)) * cells / (2 * radius), 0.0, 1.0);
}

std::vector<std::vector<dvec2>> outlines_within(const TexelShares& amounts, double disk) {
    auto lines = contours(cells, [&](int row, int column) {
        return static_cast<double>(amounts[cell_index(row, column)]) *
               share_within(disk, cell_point(row, column));
    });
    for (auto& line : lines)
        for (dvec2& at : line)
            at = dvec2(2 * (at.x + 0.5) / cells - 1, 1 - 2 * (at.y + 0.5) / cells) * radius;
    return lines;
}

template <class Amount>
TexelShares amounts_of(const Amount& amount) {
    TexelShares amounts(std::size_t{cells} * cells);
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const dvec2 at = cell_point(row, column);
            if (glm::dot(at, at) < radius * radius)
                amounts[cell_index(row, column)] = static_cast<float>(amount(cell_index(row, column), at));
        }
    return amounts;
}

}  // namespace

std::shared_ptr<const Selection> made(TexelShares amounts) {
    if (!(static_cast<double>(*std::max_element(amounts.begin(), amounts.end())) > least)) return nullptr;
    auto selection = std::make_shared<Selection>();
    selection->upper_ = outlines_within(amounts, 1);
    selection->whole_ = outlines_within(amounts, radius);
    selection->amounts_ = std::move(amounts);
    return selection;
}

double Selection::operator()(dvec3 h) const { return raster_value(amounts_, cells, disk_point(h) / radius); }

std::shared_ptr<const TexelShares> Selection::texels(const glm::dmat3& layer_frame, int side) const {
    auto shares =
        std::make_shared<TexelShares>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    visit_texels(side, {0, 0, 1}, 4, [&](std::size_t index, dvec3 h) {
        (*shares)[index] = static_cast<float>((*this)(layer_frame * h));
    });
    return shares;
}

std::shared_ptr<const Selection> select(const Selection* before, SelectMode mode, const HemisphereView& view,
                                        std::span<const dvec2> outline) {
    const PolygonCover cover(outline);
    return made(amounts_of([&](std::size_t index, dvec2 at) {
        const dvec3 h = disk_direction(at);
        const double there = before != nullptr ? static_cast<double>(before->amounts_[index]) : 0;
        const bool behind = view.camera().dome && view.hidden(h);
        const double amount = behind ? 0 : cover(view.pixel(h));
        if (mode == SelectMode::add) return std::max(there, amount);
        return mode == SelectMode::remove ? std::min(there, 1 - amount) : amount;
    }));
}

std::shared_ptr<const Selection> inverted(const Selection& selection) {
    return made(amounts_of(
        [&](std::size_t index, dvec2) { return 1 - static_cast<double>(selection.amounts_[index]); }));
}

std::shared_ptr<const Selection> carried(const Selection& selection, const DiskBox& from, const DiskBox& to) {
    return made(amounts_of([&](std::size_t, dvec2 at) {
        const dvec2 source = from.at(to.own(at));
        return glm::dot(source, source) < radius * radius ? selection(disk_direction(source)) : 0;
    }));
}

std::shared_ptr<const Selection> select_all() {
    return made(amounts_of([](std::size_t, dvec2) { return 1.0; }));
}

}  // namespace nacre
