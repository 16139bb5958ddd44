#include "core/model/lobes/gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/beckmann.h"
#include "core/model/lobe_densities.h"
#include "core/model/shading.h"
#include "core/model/span_envelope.h"

namespace nacre {
namespace {

// Eq. 34 lacks Beckmann's 1/cos^4. With X, Y the slopes and r^2 = X^2 + Y^2, the facets' projected density in
// slopes is exp(-X^2/sx^2 - Y^2/sy^2) (1 + r^2)^-2, and
//
//     (1 + r^2)^-2 = integral over t > 0 of t exp(-t (1 + r^2)) dt,
//
// so that eq. 34 is a mixture, over t, of Beckmann distributions with 1/ax^2 = 1/sx^2 + t, 1/ay^2 = 1/sy^2 +
// t:
//
//   +-------------------------------------------------------------+
//   |  g(k) = integral of t exp(-t) pi ax ay g_Beckmann(k; ax, ay) |
//   +-------------------------------------------------------------+
//
// A one-dimensional integral of a smooth function instead of a two-dimensional one with a corner, and of
// positive terms only: no digits are lost at any width. In x = log t the trapezoidal rule has an error of
// exp(-pi^2/step): exp(-t) is the narrowest feature, bounded in |Im x| < pi/2, and 1/(a + t) has its poles at
// |Im x| = pi for every width. An infinite width moves mass down to t = 1e-24 as sqrt(t); elsewhere the small
// terms are dropped.
struct Component {
    dvec2 alpha;
    double weight;  // N of the component
};

constexpr double step = 0.3;
constexpr double first = -58, last = 4.4;
constexpr double negligible =
    1e-14;  // of the sum of weight (1 + alpha), a bound of what a component adds to g

class Gaussian final : public LobeModel {
  public:
    explicit Gaussian(const GaussianLobe& lobe) : inverse_width_(1 / lobe.sigma_x, 1 / lobe.sigma_y) {
        const dvec2 a = inverse_width_ * inverse_width_;
        double bound = 0;
        for (double x = first; x <= last; x += step) {
            const double t = std::exp(x);
            const dvec2 alpha = 1.0 / glm::sqrt(a + t);
            const double n = step * t * std::exp(-t) * std::numbers::pi * alpha.x * alpha.y;
            components_.push_back({alpha, t * n});
            bound += t * n * (1 + alpha.x + alpha.y);
            // (1 + r^2)^-3/2 = 2/sqrt(pi) integral of sqrt(t) exp(-t (1 + r^2)) dt gives the solid angle.
            mass_ += 2 * std::numbers::inv_sqrtpi * std::sqrt(t) * n;
        }
        std::erase_if(components_, [&](const Component& c) {
            return c.weight * (1 + c.alpha.x + c.alpha.y) < negligible * bound;
        });
    }

    double density(dvec3 h) const override { return Shading<double>::gaussian_density(h, inverse_width_); }

    void densities(const DirectionColumns& h, double* p) const override {
        lobe_densities({kind_index<Lobe, GaussianLobe>(), inverse_width_}, h, p);
    }
    double mass() const override { return mass_; }

    Area area(dvec3 k) const override {
        Area sum;
        for (const Component& c : components_) {
            const Area part = beckmann_area(k, c.alpha);
            sum.g += c.weight * part.g;
            sum.gradient += c.weight * part.gradient;
        }
        return sum;
    }

    dvec3 mean() const override { return {0, 0, area({0, 0, 1}).g}; }

    std::vector<LobeParameterization> spans() const override {
        const dvec2 a = inverse_width_ * inverse_width_;
        return {{1.0 / glm::sqrt(a + 1.0), 1, {}}};
    }

    // In h' eq. 34 is exp(-tan^2(theta') (e.x^2/(1 + sx^2) + e.y^2/(1 + sy^2))), the solid angle falls as |A
    // h'|^3 rises.
    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_span_envelope(*this, [this](const LobeParameterization& span, const SpanCell& cell) {
            const dvec2 rate = inverse_width_ * inverse_width_ * span.stretch * span.stretch;
            const SquareBounds x2 = square_bounds(cell);
            const double least_rate =
                std::min(rate.x * x2.low + rate.y * (1 - x2.low), rate.x * x2.high + rate.y * (1 - x2.high));
            const double length = std::sqrt(stretch_bounds(span, cell).low);
            return std::exp(-least_rate * (1 / (cell.t1 * cell.t1) - 1)) * span.stretch.x * span.stretch.y /
                   (length * length * length);
        });
    }

    dvec3 sample_visible(dvec3 k, Random& random) const override {
        std::vector<double> rising;
        double sum = 0;
        for (const Component& c : components_)
            rising.push_back(sum += c.weight * beckmann_area(k, c.alpha).g);
        const auto chosen = std::upper_bound(rising.begin(), rising.end() - 1, uniform_random(random) * sum);
        return beckmann_sample_visible(
            k, components_[static_cast<std::size_t>(chosen - rising.begin())].alpha, random);
    }

  private:
    dvec2 inverse_width_;
    std::vector<Component> components_;
    double mass_ = 0;
};

}  // namespace

std::shared_ptr<const LobeModel> GaussianLobe::model() const { return std::make_shared<Gaussian>(*this); }

}  // namespace nacre
