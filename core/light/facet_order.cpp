#include "core/light/facet_order.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "core/light/hilbert.h"
#include "core/model/disk.h"

namespace nacre {
namespace {

using std::numbers::pi;

// From the square [0, 1)^2 to the unit disk; keeps ratios of areas             (Shirley & Chiu 1997)
dvec2 concentric_disk(dvec2 at) {
    const dvec2 p = 2.0 * at - 1.0;
    if (p.x == 0 && p.y == 0) return {0, 0};
    const bool wide = std::fabs(p.x) > std::fabs(p.y);
    const double r = wide ? p.x : p.y;
    const double phi = wide ? pi / 4 * (p.y / p.x) : pi / 2 - pi / 4 * (p.x / p.y);
    return {r * std::cos(phi), r * std::sin(phi)};
}

// One hemisphere of one lobe; see LobeParameterization.
class Domain {
  public:
    Domain(const PlacedLobe& placed, const LobeParameterization& span, int side)
        : placed_(&placed),
          span_(span),
          side_(side),
          cells_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}

    std::size_t cells() const { return cells_; }

    dvec3 direction(std::size_t cell, dvec2 at) const { return placed_->frame * facet(cell, at).h; }

    double mass(std::size_t cell) const {
        const Facet middle = facet(cell, {0.5, 0.5});
        return placed_->scale * placed_->lobe->density(middle.h) * middle.mass;
    }

  private:
    // In the lobe's frame, with the cell's solid angle there.
    Facet facet(std::size_t cell, dvec2 at) const {
        const dvec2 corner(hilbert_cell(static_cast<std::int64_t>(cell), side_));
        const dvec3 round = disk_direction(concentric_disk((corner + at) / static_cast<double>(side_)));
        const dvec3 stretched{span_.stretch.x * round.x, span_.stretch.y * round.y, round.z};
        const double length = glm::length(stretched);
        const double patch = 2 * pi / static_cast<double>(cells_) * span_.stretch.x * span_.stretch.y;
        dvec3 h = stretched / length;
        h.z *= span_.flip;
        return {h, patch / (length * length * length)};
    }

    const PlacedLobe* placed_;
    LobeParameterization span_;
    int side_;
    std::size_t cells_;
};

}  // namespace

DirectionOrder order_facets(const FacetDistribution& distribution, int side) {
    std::vector<Domain> domains;
    for (const PlacedLobe& placed : distribution.lobes())
        for (const LobeParameterization& span : placed.lobe->domains())
            domains.emplace_back(placed, span, side);
    const std::size_t each = domains.front().cells();
    MassCells cells;
    cells.mass.resize(domains.size() * each);
    tbb::parallel_for(std::size_t{0}, cells.mass.size(),
                      [&](std::size_t i) { cells.mass[i] = domains[i / each].mass(i % each); });
    cells.direction = [&](std::size_t cell, glm::dvec2 at) {
        return glm::normalize(domains[cell / each].direction(cell % each, at));
    };
    return order_directions(cells);
}

}  // namespace nacre
