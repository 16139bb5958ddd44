#include "core/compare/facet_slopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

constexpr std::size_t lattice_size = 16384;

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

struct Slope {
    double size;
    double area;  // as n sees it
};

double median(std::vector<Slope>& slopes) {
    std::sort(slopes.begin(), slopes.end(), [](Slope a, Slope b) { return a.size < b.size; });
    double total = 0, sum = 0;
    for (const Slope& slope : slopes) total += slope.area;
    // Straight lines between the middles of the facets' areas.
    double size = 0, middle = 0;
    for (const Slope& slope : slopes) {
        const double next = sum + 0.5 * slope.area;
        if (next >= 0.5 * total)
            return next > middle ? size + (slope.size - size) * (0.5 * total - middle) / (next - middle)
                                 : slope.size;
        size = slope.size;
        middle = next;
        sum += slope.area;
    }
    return size;
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

FacetSlopes facet_slopes(const FacetDistribution& p) {
    const std::vector<Facet> facets = facet_lattice(p, lattice_size);
    double xx = 0, xy = 0, yy = 0;
    for (const Facet& facet : facets) {
        xx += facet.mass * facet.h.x * facet.h.x;
        xy += facet.mass * facet.h.x * facet.h.y;
        yy += facet.mass * facet.h.y * facet.h.y;
    }
    // A round p keeps the surface's own axes, whatever rounding says.
    const bool round = std::hypot(xx - yy, 2 * xy) <= 1e-3 * (xx + yy);
    FacetSlopes slopes{.azimuth = round ? 0 : 0.5 * std::atan2(2 * xy, xx - yy) + pi / 2};
    const dvec3 first{std::cos(slopes.azimuth), std::sin(slopes.azimuth), 0};
    const dvec3 axes[] = {first, {-first.y, first.x, 0}};
    for (int i = 0; i < 2; ++i) {
        std::vector<Slope> along;
        for (const Facet& facet : facets)
            if (facet.h.z > 0)
                along.push_back({std::fabs(glm::dot(facet.h, axes[i])) / facet.h.z, facet.mass * facet.h.z});
        slopes.median[i] = median(along);
    }
    if (round) slopes.median = dvec2{std::sqrt(slopes.median.x * slopes.median.y)};
    return slopes;
}

}  // namespace nacre
