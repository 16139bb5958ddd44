#include "core/model/facet_lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

// Fibonacci's lattice on the upper hemisphere, stretched as the span is: on each band between two of its
// breaks, since a corner of p may stand as near to the axis as it will.
void add_span(const PlacedLobe& placed, const LobeParameterization& span, std::size_t count,
              std::vector<Facet>& all) {
    std::vector<double> edges = {1};  // cosines of the angle from the axis
    for (const double angle : span.breaks) edges.push_back(std::cos(angle));
    edges.push_back(0);
    const std::size_t own = std::max<std::size_t>(count / (edges.size() - 1), 64);
    const double turn = pi * (3 - std::sqrt(5.0));
    for (std::size_t band = 0; band + 1 < edges.size(); ++band) {
        const double step = (edges[band] - edges[band + 1]) / static_cast<double>(own);
        const double patch = 2 * pi * step * span.stretch.x * span.stretch.y;
        for (std::size_t i = 0; i < own; ++i) {
            const double at = static_cast<double>(i);
            const double z = edges[band] - (at + 0.5) * step, r = std::sqrt((1 - z) * (1 + z));
            const dvec3 stretched{span.stretch.x * r * std::cos(turn * at),
                                  span.stretch.y * r * std::sin(turn * at), z};
            const double length = glm::length(stretched);
            dvec3 h = stretched / length;
            h.z *= span.flip;
            const double mass = placed.scale * placed.lobe->density(h) * patch / (length * length * length);
            if (mass > 0) all.push_back({placed.frame * h, mass});
        }
    }
}

}  // namespace

std::vector<Facet> facet_lattice(const FacetDistribution& p, std::size_t count) {
    std::vector<Facet> all;
    const std::vector<std::vector<Facet>> own = p.facets(count);
    for (std::size_t i = 0; i < own.size(); ++i) {
        all.insert(all.end(), own[i].begin(), own[i].end());
        for (const LobeParameterization& span : p.lobes()[i].lobe->spans())
            add_span(p.lobes()[i], span, count, all);
    }
    return all;
}

}  // namespace nacre
