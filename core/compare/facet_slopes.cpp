#include "core/compare/facet_slopes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/facet_lattice.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr std::size_t lattice_size = 16384;

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

double oren_nayar_sigma(const FacetDistribution& p) {
    double sum = 0, all = 0;
    for (const Facet& facet : facet_lattice(p, lattice_size)) {
        const double theta = std::acos(std::clamp(facet.h.z, -1.0, 1.0));
        sum += facet.mass * theta * theta;
        all += facet.mass;
    }
    return std::sqrt(sum / (2 * all));
}

}  // namespace nacre
