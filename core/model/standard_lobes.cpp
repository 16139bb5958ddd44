#include <boost/math/special_functions/ellint_rg.hpp>
#include <cmath>
#include <numbers>

#include "core/model/beckmann.h"
#include "core/model/lobe_densities.h"
#include "core/model/shading.h"
#include "core/model/span_envelope.h"

namespace nacre {
namespace {

using std::numbers::pi;

// Unnormalised densities are pi ax ay times the normalised ones (N = 1) of docs/mathematics.md, sec. 7.
class Ggx final : public LobeModel {
  public:
    explicit Ggx(const GgxLobe& lobe) : alpha_(lobe.alpha_x, lobe.alpha_y), n_(pi * alpha_.x * alpha_.y) {}

    double density(dvec3 h) const override { return Shading<double>::ggx_density(h, 1.0 / alpha_); }

    void densities(const DirectionColumns& h, double* p) const override {
        lobe_densities({kind_index<Lobe, GgxLobe>(), 1.0 / alpha_}, h, p);
    }

    // GGX is the normals of half an ellipsoid with axes 1/ax, 1/ay, 1: its area over its projected area is
    // 2 R_G(1, ax^2, ay^2) in Carlson's symmetric form.
    double mass() const override {
        return n_ * 2 * boost::math::ellint_rg(1.0, alpha_.x * alpha_.x, alpha_.y * alpha_.y);
    }

    // g = (kz + r)/2, r = |(ax kx, ay ky, kz)|; below the horizon the same without cancellation.
    Area area(dvec3 k) const override {
        const dvec2 s{alpha_.x * k.x, alpha_.y * k.y};
        const double r = std::hypot(s.x, s.y, k.z);
        if (r == 0) return {};
        const double g = k.z >= 0 ? 0.5 * (k.z + r) : 0.5 * glm::dot(s, s) / (r - k.z);
        const dvec3 gradient = 0.5 * dvec3{alpha_.x * s.x / r, alpha_.y * s.y / r, 1 + k.z / r};
        return {n_ * g, n_ * gradient};
    }

    dvec3 mean() const override { return {0, 0, n_}; }
    std::vector<LobeParameterization> spans() const override { return {{alpha_, 1, {}}}; }

    // In h' it is |A h'| times both widths.
    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_span_envelope(*this, [](const LobeParameterization& span, const SpanCell& cell) {
            return span.stretch.x * span.stretch.y * std::sqrt(stretch_bounds(span, cell).high);
        });
    }
    bool closed_form() const override { return true; }

    // Spherical caps (Dupuy & Benyoub 2023), which hold for k below the horizon too.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const dvec3 s = glm::normalize(dvec3{alpha_.x * k.x, alpha_.y * k.y, k.z});
        const double z = (1 - uniform_random(random)) * (1 + s.z) - s.z;
        const double phi = 2 * pi * uniform_random(random);
        const double sine = std::sqrt(std::fmax(1 - z * z, 0.0));
        const dvec3 c = dvec3{sine * std::cos(phi), sine * std::sin(phi), z} + s;
        return glm::normalize(dvec3{alpha_.x * c.x, alpha_.y * c.y, std::fmax(c.z, 0.0)});
    }

  private:
    dvec2 alpha_;
    double n_;
};

class Beckmann final : public LobeModel {
  public:
    explicit Beckmann(const BeckmannLobe& lobe)
        : alpha_(lobe.alpha_x, lobe.alpha_y), n_(pi * alpha_.x * alpha_.y) {}

    double density(dvec3 h) const override { return Shading<double>::beckmann_density(h, 1.0 / alpha_); }

    void densities(const DirectionColumns& h, double* p) const override {
        lobe_densities({kind_index<Lobe, BeckmannLobe>(), 1.0 / alpha_}, h, p);
    }

    // The mean of sqrt(1 + r^2) over Gaussian slopes, from
    //   sqrt(1 + r^2) = integral of (1 - exp(-t (1 + r^2))) t^-3/2 dt / (2 sqrt(pi)),
    // by the trapezoidal rule in t = exp(x); both tails fall as exp(-|x|/2).
    double mass() const override {
        const dvec2 a2 = alpha_ * alpha_;
        double sum = 0;
        constexpr double step = 0.25;
        for (double x = -84; x <= 84; x += step) {
            const double t = std::exp(x);
            const double log_kept = t + 0.5 * (std::log1p(t * a2.x) + std::log1p(t * a2.y));
            sum += step * -std::expm1(-log_kept) / std::sqrt(t);
        }
        return n_ * 0.5 * std::numbers::inv_sqrtpi * sum;
    }

    Area area(dvec3 k) const override {
        const Area unit = beckmann_area(k, alpha_);
        return {n_ * unit.g, n_ * unit.gradient};
    }

    dvec3 mean() const override { return {0, 0, n_}; }
    std::vector<LobeParameterization> spans() const override { return {{alpha_, 1, {}}}; }

    // In h' it is s^2 exp(1 - s) |A h'| times both widths, s = 1/t^2, with its maximum at s = 2.
    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_span_envelope(*this, [](const LobeParameterization& span, const SpanCell& cell) {
            const double near = 1 / (cell.t1 * cell.t1), far = 1 / (cell.t0 * cell.t0);
            const double s = std::fmin(std::fmax(near, 2.0), far);
            return span.stretch.x * span.stretch.y * s * s * std::exp(1 - s) *
                   std::sqrt(stretch_bounds(span, cell).high);
        });
    }

    dvec3 sample_visible(dvec3 k, Random& random) const override {
        return beckmann_sample_visible(k, alpha_, random);
    }

  private:
    dvec2 alpha_;
    double n_;
};

class Uniform final : public LobeModel {
  public:
    explicit Uniform(UniformDomain domain) : sphere_(domain == UniformDomain::sphere) {}

    double density(dvec3 h) const override { return sphere_ || h.z > 0 ? 1 : 0; }
    double mass() const override { return sphere_ ? 4 * pi : 2 * pi; }

    Area area(dvec3 k) const override {
        if (sphere_) return {pi, pi * k};
        const double length = glm::length(k);
        return {pi * 0.5 * (length + k.z), pi * 0.5 * (k / length + dvec3{0, 0, 1})};
    }

    dvec3 mean() const override { return {0, 0, sphere_ ? 0 : pi}; }

    std::vector<LobeParameterization> spans() const override {
        if (sphere_) return {{dvec2{1}, 1, {}}, {dvec2{1}, -1, {}}};
        return {{dvec2{1}, 1, {}}};
    }

    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_span_envelope(*this, [](const LobeParameterization&, const SpanCell&) { return 1.0; });
    }
    bool closed_form() const override { return true; }

    // A hemisphere is GGX of width 1; a sphere is seen as a cosine about k.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const double z =
            sphere_ ? 1 - 2 * uniform_random(random) : (1 - uniform_random(random)) * (1 + k.z) - k.z;
        const double phi = 2 * pi * uniform_random(random);
        const double sine = std::sqrt(std::fmax(1 - z * z, 0.0));
        return glm::normalize(dvec3{sine * std::cos(phi), sine * std::sin(phi), z} + k);
    }

  private:
    bool sphere_;
};

}  // namespace

std::shared_ptr<const LobeModel> GgxLobe::model() const { return std::make_shared<Ggx>(*this); }

std::shared_ptr<const LobeModel> BeckmannLobe::model() const { return std::make_shared<Beckmann>(*this); }

std::shared_ptr<const LobeModel> UniformLobe::model() const { return std::make_shared<Uniform>(domain); }

}  // namespace nacre
