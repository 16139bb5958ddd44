#include "core/verify/picture_rule.h"

#include "core/model/disk.h"
#include "core/model/pyramid_tile.h"

namespace nacre {
namespace {

constexpr std::size_t points = 4;

// Gauss's four points on [0, 1].
const std::array<double, points>& nodes() {
    static const std::array<double, points> places = [] {
        const double near = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2));
        const double far = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
        return std::array{0.5 - 0.5 * far, 0.5 - 0.5 * near, 0.5 + 0.5 * near, 0.5 + 0.5 * far};
    }();
    return places;
}

// The cubics that are 1 at one of the points and 0 at the others.
std::array<double, points> cubics(double x) {
    std::array<double, points> values;
    for (std::size_t i = 0; i < points; ++i) {
        values[i] = 1;
        for (std::size_t j = 0; j < points; ++j)
            if (j != i) values[i] *= (x - nodes()[j]) / (nodes()[i] - nodes()[j]);
    }
    return values;
}

std::size_t spread_bits(std::size_t x) {
    std::size_t result = 0;
    for (std::size_t bit = 0; bit < 16; ++bit) result |= ((x >> bit) & 1) << (2 * bit);
    return result;
}

}  // namespace

PictureRule::PictureRule(const PlacedLobe& placed) : placed_(placed) {
    for (const LobeParameterization& span : placed.lobe->domains()) {
        domains_.push_back({span, {}});
        for (int level = 0; level <= last_level; ++level)
            domains_.back().weight[static_cast<std::size_t>(level)].resize(boxes_at(level) * weights);
    }
    placed.lobe->visit_points([&](const Facet& facet) { add_point(facet); });
    for (Domain& domain : domains_) add_up(domain);
}

void PictureRule::add_point(const Facet& facet) {
    for (Domain& domain : domains_) {
        const LobeParameterization& span = domain.span;
        if (facet.h.z * span.flip < 0) continue;
        const dvec3 own = glm::normalize(
            dvec3(facet.h.x / span.stretch.x, facet.h.y / span.stretch.y, facet.h.z * span.flip));
        constexpr int side = 1 << last_level;
        const dvec2 place = 0.5 * (disk_point(own) + 1.0) * static_cast<double>(side);
        const dvec2 box = glm::clamp(glm::floor(place), 0.0, side - 1.0);
        const auto x = cubics(place.x - box.x), y = cubics(place.y - box.y);
        double* weight =
            &domain.weight[last_level][weights * (spread_bits(static_cast<std::size_t>(box.x)) +
                                                  2 * spread_bits(static_cast<std::size_t>(box.y)))];
        for (std::size_t i = 0; i < points; ++i)
            for (std::size_t j = 0; j < points; ++j)
                weight[points * i + j] += placed_.scale * facet.mass * y[i] * x[j];
        return;
    }
}

// A parent's cubics are cubics on each child, so that the child's points give their integrals.
void PictureRule::add_up(Domain& domain) {
    std::array<std::array<std::array<double, points>, points>, 2> cubic;  // of half, at its point
    for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t a = 0; a < points; ++a)
            cubic[half][a] = cubics(0.5 * (static_cast<double>(half) + nodes()[a]));
    for (int level = last_level; level-- > 0;) {
        const std::vector<double>& below = domain.weight[static_cast<std::size_t>(level) + 1];
        std::vector<double>& here = domain.weight[static_cast<std::size_t>(level)];
        for (std::size_t child = 0; child < boxes_at(level + 1); ++child)
            for (std::size_t a = 0; a < points; ++a)
                for (std::size_t b = 0; b < points; ++b) {
                    const double part = below[weights * child + points * a + b];
                    if (part == 0) continue;
                    const auto& y = cubic[child / 2 % 2][a];
                    const auto& x = cubic[child % 2][b];
                    for (std::size_t i = 0; i < points; ++i)
                        for (std::size_t j = 0; j < points; ++j)
                            here[weights * (child / 4) + points * i + j] += part * y[i] * x[j];
                }
    }
}

dvec3 PictureRule::node(const Domain& domain, int level, std::size_t box, std::size_t point) const {
    const double size = 2.0 / static_cast<double>(1 << level);
    const dvec2 at(size * (morton_column(box) + nodes()[point % points]) - 1,
                   size * (morton_row(box) + nodes()[point / points]) - 1);
    const dvec3 own = disk_direction(at);
    const LobeParameterization& span = domain.span;
    return placed_.frame *
           glm::normalize(dvec3(own.x * span.stretch.x, own.y * span.stretch.y, own.z * span.flip));
}

}  // namespace nacre
