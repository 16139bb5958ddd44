#include "core/bake/coat_lobe.h"

#include <cmath>
#include <numbers>

#include "core/design/design.h"
#include "core/model/quadrature.h"

namespace nacre {
namespace {

using std::numbers::pi;

// Slopes past this many widths are one in 10^7.
constexpr double slopes_max = 4;
constexpr int azimuths = 64;  // of half a turn

}  // namespace

// With slopes sx, sy of facets, D c_h dh = exp(-(sx^2 + sy^2)/width^2)/(pi width^2) dsx dsy, and a facet adds
// F (k1.h)/c_h c2/(g1 g2) of that.
double coat_albedo(const Shading<double>& shading, double cosine) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const dvec3 k1{sine, 0, cosine};
    const double g1 = shading.coat_area(cosine), width = shading.surface.coat_width;
    const auto at = [&](double radius, double phi) {
        const dvec3 slope{width * radius * std::cos(phi), width * radius * std::sin(phi), 1};
        const double length = glm::length(slope), seen = glm::dot(k1, slope), kh = seen / length;
        const double c2 = 2 * kh / length - cosine;
        if (seen <= 0 || c2 <= 0) return 0.0;
        const double f =
            Shading<double>::dielectric_reflectance(shading.surface.coat_ior, std::fmin(kh, 1.0));
        return f * seen * c2 / (g1 * shading.coat_area(std::fmin(c2, 1.0)));
    };
    double sum = 0;
    constexpr int bands = 2;
    for (int band = 0; band < bands; ++band)
        for (const QuadraturePoint& node : gauss_legendre<20>()) {
            const double step = slopes_max / bands, radius = step * (band + node.x);
            const double weight = step * node.weight * 2 * radius * std::exp(-radius * radius) / azimuths;
            for (int i = 0; i < azimuths; ++i) sum += weight * at(radius, pi * (i + 0.5) / azimuths);
        }
    return std::fmin(sum, 1.0);
}

std::vector<float> coat_albedo_table(const Shading<double>& shading, Workers& workers) {
    std::vector<float> table(coat_albedo_nodes);
    workers.for_each(coat_albedo_nodes, [&](int i) {
        const double root = i / (coat_albedo_nodes - 1.0);
        table[static_cast<std::size_t>(i)] = static_cast<float>(coat_albedo(shading, root * root));
    });
    return table;
}

std::shared_ptr<const FacetDistribution> coat_facets(const Coat& coat) {
    return std::visit(
        []<class T>(const T& kind) -> std::shared_ptr<const FacetDistribution> {
            if constexpr (T::covers) {
                Distribution distribution;
                distribution.layers[0].lobe = kind.lobe();
                return std::make_shared<const FacetDistribution>(distribution);
            } else {
                return {};
            }
        },
        coat);
}

}  // namespace nacre
