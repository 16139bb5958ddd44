#include "core/paint/highlight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/paint/brush.h"
#include "core/paint/hills.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"

namespace nacre {

std::optional<Highlight> Highlight::under(const Raster& raster, dvec3 at) {
    const glm::dvec2 point = disk_point(above_horizon(at));
    const auto cell = [](double along) {
        return std::clamp(static_cast<int>(std::floor(along * hill_cells)), 0, hill_cells - 1);
    };
    const auto membership = hill_around(raster, cell((1 - point.y) / 2), cell((point.x + 1) / 2));
    if (!membership) return {};
    Highlight highlight(raster, above_horizon(at), *membership);
    if (!(raster_mass(highlight.part_) > 0)) return {};
    return highlight;
}

Highlight::Highlight(const Raster& raster, dvec3 at, const std::vector<float>& membership)
    : part_(raster), rest_(raster), at_(at) {
    // Beyond the outermost middles cells keep their membership.
    const double inside = 1 - 1.0 / hill_cells;
    std::size_t index = 0;
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column, ++index) {
            const auto value = static_cast<double>(raster.values[index]);
            if (!(value > 0)) continue;
            const glm::dvec2 point = texel_point(raster.width, row, column);
            const double share = raster_value(membership, hill_cells, glm::clamp(point, -inside, inside));
            const bool moves = share > 0 && holds_facets(point);
            part_.values[index] = moves ? static_cast<float>(value * share) : 0;
            rest_.values[index] = static_cast<float>(value * (1 - share));
            if (moves) reach_ = std::max(reach_, angle_between(at_, disk_direction(point)));
        }
}

std::shared_ptr<const Raster> Highlight::carried(dvec3 to) const {
    to = above_horizon(to);
    if (glm::dot(at_, to) < -0.999) return nullptr;
    const int side = part_.width;
    auto result = std::make_shared<Raster>(rest_);
    const glm::dmat3 back = shortest_rotation(to, at_);
    const Raster part = extended_past_rim(part_);
    Raster moved{side, side, std::vector<float>(part.values.size())};
    visit_texels(side, to, reach_ + 4.0 / side, [&](std::size_t index, dvec3 h) {
        moved.values[index] = static_cast<float>(raster_value(part.values, side, disk_point(back * h)));
    });
    const double mass = raster_mass(moved);
    if (!(mass > 0)) return nullptr;
    const double factor = raster_mass(part_) / mass;
    std::vector<double> sums(result->values.begin(), result->values.end());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += factor * static_cast<double>(moved.values[i]);
    const double unit = std::max(1.0, *std::max_element(sums.begin(), sums.end()));
    std::transform(sums.begin(), sums.end(), result->values.begin(),
                   [&](double value) { return static_cast<float>(value / unit); });
    return result;
}

}  // namespace nacre
