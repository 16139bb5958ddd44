#include "core/study/harmonic_area.h"

#include <cmath>
#include <numbers>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr std::size_t most_facets = 65536;  // of a picture

}  // namespace

HarmonicArea::HarmonicArea(const FacetDistribution& distribution, int degree, bool round,
                           const std::stop_token& stop)
    : basis_(degree, round), coefficients_(basis_.size(), 0), values_(basis_.size(), 0) {
    const auto facets = distribution.facets(most_facets);
    const auto& rule = gauss_legendre<64>();
    // The harmonics turn `degree` times about the axis, p in a stretched frame somewhat more.
    const int azimuths = round ? 1 : 4 * degree + 32;
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const PlacedLobe& placed = distribution.lobes()[i];
        for (const Facet& facet : facets[i]) {
            if (stop.stop_requested()) throw BakeCancelled();
            add(facet);
        }
        for (const LobeParameterization& span : placed.lobe->spans()) {
            const GreatCircleQuadrature walk(placed, span, {0, 0, 1});
            std::vector<double> cuts = {0};
            for (const double at : span.breaks)
                if (at > 0 && at < 0.5 * pi) cuts.push_back(at);
            cuts.push_back(0.5 * pi);
            for (int j = 0; j < azimuths; ++j) {
                if (stop.stop_requested()) throw BakeCancelled();
                const GreatCircleQuadrature::Ray ray = walk.ray(walk.start() + 2 * pi * j / azimuths);
                for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
                    for (const QuadraturePoint& point : rule) {
                        Facet facet = walk.facet(ray, cuts[c] + (cuts[c + 1] - cuts[c]) * point.x);
                        facet.mass *= (cuts[c + 1] - cuts[c]) * point.weight * 2 * pi / azimuths;
                        add(facet);
                    }
            }
        }
    }
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
        coefficients_[i] *= clamped_cosine_factor(basis_.degree_of(i));
}

void HarmonicArea::add(const Facet& facet) {
    if (facet.mass <= 0) return;
    basis_.evaluate(facet.h, values_);
    for (std::size_t i = 0; i < values_.size(); ++i) coefficients_[i] += facet.mass * values_[i];
}

double HarmonicArea::operator()(dvec3 k) const {
    std::vector<double> values(basis_.size());
    basis_.evaluate(k, values);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += coefficients_[i] * values[i];
    return sum;
}

double HarmonicArea::upper_half() const {
    double whole = 0, upper = 0;
    for (std::size_t i = 0; i < coefficients_.size(); ++i) {
        const double square = coefficients_[i] * coefficients_[i];
        whole += square;
        if (2 * basis_.degree_of(i) > basis_.degree()) upper += square;
    }
    return std::sqrt(upper / whole);
}

}  // namespace nacre
