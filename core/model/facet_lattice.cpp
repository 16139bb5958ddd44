#include "core/model/facet_lattice.h"

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

// Fibonacci's lattice on the upper hemisphere, stretched as the span is.
void add_span(const PlacedLobe& placed, const LobeParameterization& span, std::size_t count,
              std::vector<Facet>& all) {
    const double patch = 2 * pi / static_cast<double>(count) * span.stretch.x * span.stretch.y;
    const double turn = pi * (3 - std::sqrt(5.0));
    for (std::size_t i = 0; i < count; ++i) {
        const double at = static_cast<double>(i);
        const double z = 1 - (at + 0.5) / static_cast<double>(count), r = std::sqrt(1 - z * z);
        const dvec3 own{span.stretch.x * r * std::cos(turn * at), span.stretch.y * r * std::sin(turn * at),
                        z};
        const double length = glm::length(own);
        dvec3 h = own / length;
        h.z *= span.flip;
        const double mass = placed.scale * placed.lobe->density(h) * patch / (length * length * length);
        if (mass > 0) all.push_back({placed.frame * h, mass});
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
