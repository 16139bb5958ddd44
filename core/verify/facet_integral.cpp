#include "core/verify/facet_integral.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/model/quadrature.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Pair = Values<2>;

constexpr double check_tolerance = 1e-9;
constexpr int depth = 18;
// Of a modulated lobe: points along azimuth and along the angle from the axis.
constexpr int grid_side = 1500;

// p over one hemisphere, and p times (k.h)+ of each of these k, divided by `unit`.
class SpanIntegral {
  public:
    SpanIntegral(const PlacedLobe& placed, const LobeParameterization& span, std::vector<dvec3> k,
                 double unit, double tolerance, const std::stop_token& stop)
        : walk_(placed, span, k.front()),
          span_(span),
          k_(std::move(k)),
          unit_(unit),
          tolerance_(tolerance),
          stop_(stop) {}

    // Where k grazes, facets turn from it at all angles within a hair of each half's ends.
    Pair adaptive() const {
        Pair sum{};
        for (int half = 0; half < 2; ++half) {
            const auto at = [&](double s) {
                const QuadraturePoint psi = toward_ends(s);
                Pair values = over_chi(walk_.start() + (half + psi.x) * pi);
                for (double& value : values) value *= pi * psi.weight;
                return values;
            };
            const Pair part = integrate_adaptively<2>(at, 0, 1, tolerance_, depth);
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
        }
        return sum;
    }

    Pair on_grid() const {
        Pair sum{};
        const double step_psi = 2 * pi / grid_side, step_chi = 0.5 * pi / grid_side;
        for (int i = 0; i < grid_side; ++i) {
            if (stop_.stop_requested()) throw BakeCancelled();
            for (int j = 0; j < grid_side; ++j) {
                const Pair values = at(walk_.start() + (i + 0.5) * step_psi, (j + 0.5) * step_chi);
                for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += values[c] * step_psi * step_chi;
            }
        }
        return sum;
    }

  private:
    Pair at(double psi, double chi) const {
        const Facet facet = walk_.facet(walk_.ray(psi), chi);
        double seen = facet.mass / unit_;
        for (const dvec3& k : k_) seen *= std::fmax(glm::dot(facet.h, k), 0.0);
        return {facet.mass, seen};
    }

    // The angle at which the great circle's facets turn from k: k.a cos(chi) + |e| k.e sin(chi) = 0.
    double turning_angle(dvec3 k, double psi) const {
        const double size = std::hypot(span_.stretch.x * std::cos(psi), span_.stretch.y * std::sin(psi));
        const double ka = glm::dot(k, walk_.facet(walk_.ray(psi), 0).h);
        const double ke = glm::dot(k, walk_.facet(walk_.ray(psi), 0.5 * pi).h) * size;
        return std::atan2(ka, -ke);
    }

    Pair over_chi(double psi) const {
        if (stop_.stop_requested()) throw BakeCancelled();
        std::vector<double> cuts = {0, 0.5 * pi};
        for (const dvec3& k : k_) cuts.push_back(turning_angle(k, psi));
        cuts.insert(cuts.end(), span_.breaks.begin(), span_.breaks.end());
        std::sort(cuts.begin(), cuts.end());
        Pair sum{};
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i] < 0 || cuts[i + 1] > 0.5 * pi || cuts[i + 1] <= cuts[i]) continue;
            const Pair part = integrate_adaptively<2>([&](double chi) { return at(psi, chi); }, cuts[i],
                                                      cuts[i + 1], 0.2 * tolerance_, depth);
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += part[c];
        }
        return sum;
    }

    GreatCircleQuadrature walk_;
    LobeParameterization span_;
    std::vector<dvec3> k_;
    double unit_, tolerance_;
    const std::stop_token& stop_;
};

// A painted p by its own cells.
void add_points(FacetIntegral& sum, const PlacedLobe& placed, dvec3 k, const std::stop_token& stop) {
    const dvec3 own = glm::transpose(placed.frame) * k;
    placed.lobe->visit_points([&](const Facet& facet) {
        if (stop.stop_requested()) throw BakeCancelled();
        sum.whole += placed.scale * facet.mass;
        sum.visible += placed.scale * facet.mass * std::fmax(glm::dot(facet.h, own), 0.0);
    });
}

}  // namespace

bool holds_picture(const Distribution& design) {
    return std::any_of(design.layers.begin(), design.layers.end(),
                       [](const Layer& layer) { return counts(layer) && holds_picture(layer); });
}

FacetIntegral integrate_facets(const Distribution& design, const FacetDistribution& distribution, dvec3 k,
                               std::stop_token stop) {
    const double unit = std::fmax(distribution.area(k).g, 1e-30);
    FacetIntegral sum;
    for (const PlacedLobe& placed : distribution.lobes()) {
        const Layer& layer = design.layers[placed.layer];
        if (std::holds_alternative<PaintedLobe>(layer.lobe)) {
            add_points(sum, placed, k, stop);
            continue;
        }
        for (const LobeParameterization& span : placed.lobe->domains()) {
            const SpanIntegral integral(placed, span, {k}, unit, check_tolerance, stop);
            const Pair values = layer.modulation ? integral.on_grid() : integral.adaptive();
            sum.whole += values[0];
            sum.visible += values[1] * unit;
        }
    }
    return sum;
}

double AdaptiveArea::operator()(dvec3 k, const std::stop_token& stop) const {
    double sum = 0;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const PlacedLobe& placed = distribution_.lobes()[i];
        for (const Facet& facet : facets_[i]) sum += facet.mass * std::fmax(glm::dot(facet.h, k), 0.0);
        for (const LobeParameterization& span : placed.lobe->spans())
            sum += SpanIntegral(placed, span, {k}, 1, tolerance_, stop).adaptive()[1];
    }
    return sum;
}

double AdaptiveProduct::operator()(dvec3 k1, dvec3 k2, double tolerance, const std::stop_token& stop) const {
    double sum = 0;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const PlacedLobe& placed = distribution_.lobes()[i];
        for (const Facet& facet : facets_[i])
            sum += facet.mass * std::fmax(glm::dot(facet.h, k1), 0.0) * std::fmax(glm::dot(facet.h, k2), 0.0);
        for (const LobeParameterization& span : placed.lobe->spans())
            sum += SpanIntegral(placed, span, {k1, k2}, 1, tolerance, stop).adaptive()[1];
    }
    return sum;
}

}  // namespace nacre
