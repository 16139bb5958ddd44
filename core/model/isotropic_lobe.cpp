#include "core/model/lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/lobe_densities.h"
#include "core/model/quadrature.h"
#include "core/model/shading.h"
#include "core/model/span_envelope.h"

namespace nacre {
namespace {

using std::numbers::pi;

// The ring of facets at theta, integrated over azimuth: how much of them k sees and where they point.
struct Ring {
    double tangential;  // integral of h along k's azimuth over the visible part
    double axial;       // integral of h.z
};

Ring visible_ring(double sine, double cosine, double k_sine, double k_cosine) {
    const double a = cosine * k_cosine, b = sine * k_sine;
    if (a >= b) return {0, 2 * pi * cosine};
    if (a <= -b) return {0, 0};
    const double phi = std::acos(-a / b);
    return {2 * sine * std::sin(phi), 2 * cosine * phi};
}

// theta over a piece of p that holds no corner; at the ends a ring begins or ceases to be wholly visible.
template <class Visit>
void for_each_node(double a, double b, std::size_t pieces, const Visit& visit) {
    const auto& rule = pieces > 24  ? gauss_legendre<10>()
                       : pieces > 5 ? gauss_legendre<16>()
                                    : gauss_legendre<32>();
    for (const QuadraturePoint& node : rule) {
        const QuadraturePoint at = toward_ends(node.x);
        visit(a + (b - a) * at.x, (b - a) * at.weight * node.weight);
    }
}

// A function of theta with corners at `breaks` (angles after the stretch, see LobeParameterization).
class Isotropic : public LobeModel {
  public:
    Area area(dvec3 k) const override {
        const double k_sine = std::hypot(k.x, k.y), k_cosine = k.z;
        const double turn = std::atan2(std::fabs(k_cosine), k_sine);
        Area sum;
        double tangential = 0, axial = 0;
        for_each_piece(turn, [&](double theta, double weight) {
            const Ring ring = visible_ring(std::sin(theta), std::cos(theta), k_sine, k_cosine);
            tangential += weight * ring.tangential;
            axial += weight * ring.axial;
        });
        sum.g = std::fmax(k_sine * tangential + k_cosine * axial, 0.0);
        const double scale = k_sine > 0 ? tangential / k_sine : 0;
        sum.gradient = {scale * k.x, scale * k.y, axial};
        return sum;
    }

    double mass() const override {
        double sum = 0;
        for_each_piece(pi / 2, [&](double, double weight) { sum += 2 * pi * weight; });
        return sum;
    }

    // Draws theta from the masses of thin rings times a bound of what k sees of them, then azimuth, both by
    // rejection against the exact density; |d(seen)/d(theta)| <= 1 bounds a ring by its ends.
    dvec3 sample_visible(dvec3 k, Random& random) const override {
        const double k_sine = std::hypot(k.x, k.y);
        const double azimuth = k_sine > 0 ? std::atan2(k.y, k.x) : 0;
        std::vector<double> bound(rings_.size());
        double total = 0;
        for (std::size_t i = 0; i < rings_.size(); ++i) {
            const ThinRing& r = rings_[i];
            const double seen = std::fmax(mean_seen(r.theta0, k_sine, k.z), mean_seen(r.theta1, k_sine, k.z));
            total += bound[i] =
                r.peak * (r.theta1 - r.theta0) * std::fmin(seen + 0.5 * (r.theta1 - r.theta0), 1.0);
        }
        for (;;) {
            double left = uniform_random(random) * total;
            std::size_t i = 0;
            while (i + 1 < rings_.size() && left >= bound[i]) left -= bound[i++];
            const ThinRing& r = rings_[i];
            const double theta = r.theta0 + (r.theta1 - r.theta0) * uniform_random(random);
            const double ceiling = bound[i] / (r.theta1 - r.theta0);
            const double seen = mean_seen(theta, k_sine, k.z);
            if (uniform_random(random) * ceiling >= profile(theta) * std::sin(theta) * seen) continue;
            const double a = std::cos(theta) * k.z, b = std::sin(theta) * k_sine;
            const double half = a >= b ? pi : std::acos(std::fmax(-a / b, -1.0));
            for (;;) {
                const double phi = (2 * uniform_random(random) - 1) * half;
                if (uniform_random(random) * (a + b) > a + b * std::cos(phi)) continue;
                return {std::sin(theta) * std::cos(phi + azimuth), std::sin(theta) * std::sin(phi + azimuth),
                        std::cos(theta)};
            }
        }
    }

  protected:
    // Pieces: rising angles chi in h' that bound smooth parts of p; theta = atan2(stretch sin chi, cos chi).
    void set_pieces(double stretch, std::vector<double> pieces) {
        stretch_ = stretch;
        pieces_ = std::move(pieces);
        constexpr int thin = 128;
        const double a = pieces_.front(), b = pieces_.back();
        for (int i = 0; i < thin; ++i) {
            const double theta0 = theta_of(a + (b - a) * i / thin),
                         theta1 = theta_of(a + (b - a) * (i + 1) / thin);
            const double peak = peak_over(theta0, theta1);
            if (peak > 0) rings_.push_back({theta0, theta1, peak});
        }
    }

    virtual double profile(double theta) const = 0;
    // An upper bound of p(theta) sin(theta) between two angles, close where they are.
    virtual double peak_over(double theta0, double theta1) const = 0;

    double stretch_ = 1;
    std::vector<double> pieces_;

  private:
    struct ThinRing {
        double theta0, theta1, peak;
    };

    // Mean of (h.k)+ over the azimuth of a ring.
    static double mean_seen(double theta, double k_sine, double k_cosine) {
        const Ring ring = visible_ring(std::sin(theta), std::cos(theta), k_sine, k_cosine);
        return std::fmax(k_sine * ring.tangential + k_cosine * ring.axial, 0.0) / (2 * pi);
    }

    double theta_of(double chi) const { return std::atan2(stretch_ * std::sin(chi), std::cos(chi)); }
    double chi_of(double theta) const { return std::atan2(std::sin(theta), stretch_ * std::cos(theta)); }

    // Visits theta with the weight p(theta) sin(theta) dtheta, in pieces also cut where rings at `turn` and
    // at pi - turn begin to be seen in part.
    template <class Visit>
    void for_each_piece(double turn, const Visit& visit) const {
        std::vector<double> cuts = pieces_;
        for (const double theta : {turn, pi - turn}) {
            const double chi = chi_of(theta);
            if (chi > pieces_.front() && chi < pieces_.back()) cuts.push_back(chi);
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] <= cuts[i]) continue;
            for_each_node(cuts[i], cuts[i + 1], pieces_.size(), [&](double chi, double weight) {
                const double s = stretch_ * std::sin(chi), c = std::cos(chi);
                const double theta = std::atan2(s, c);
                const double weighted =
                    profile(theta) * std::sin(theta) * stretch_ / (s * s + c * c) * weight;
                if (weighted > 0) visit(theta, weighted);
            });
        }
    }

    std::vector<ThinRing> rings_;
};

class InverseGaussian final : public Isotropic {
  public:
    explicit InverseGaussian(const InverseGaussianLobe& lobe) : inverse_width_(1 / lobe.sigma) {
        // Facets crowd at cot(theta) < sigma: the stretch that makes that width one.
        // The exponential is cot^2(chi)/(1 + sigma^2): split about where it rises from 0, which one
        // Gauss rule over all of it would resolve badly.
        const double rise = std::atan(1 / std::hypot(1, lobe.sigma));
        set_pieces(std::hypot(1, inverse_width_), {0, 0.5 * rise, rise, 0.5 * (rise + pi / 2), pi / 2});
    }

    double density(dvec3 h) const override {
        return Shading<double>::inverse_gaussian_density(h, inverse_width_);
    }

    void densities(const DirectionColumns& h, double* p) const override {
        lobe_densities({kind_index<Lobe, InverseGaussianLobe>(), dvec2{inverse_width_}}, h, p);
    }
    dvec3 mean() const override { return {0, 0, area({0, 0, 1}).g}; }
    std::vector<LobeParameterization> spans() const override { return {{dvec2{stretch_}, 1, {}}}; }

    // p rises toward the horizon; the solid angle toward the axis, since the stretch is above 1.
    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_span_envelope(*this, [this](const LobeParameterization& span, const SpanCell& cell) {
            const double length = std::sqrt(stretch_bounds(span, cell).low), t = std::fmax(cell.t0, 1e-9);
            const double sine = stretch_ * std::sqrt(1 - t * t);
            return density(dvec3{sine, 0, t} / std::hypot(sine, t)) * stretch_ * stretch_ /
                   (length * length * length);
        });
    }

  protected:
    double profile(double theta) const override { return density({std::sin(theta), 0, std::cos(theta)}); }
    double peak_over(double, double theta1) const override {
        return profile(std::fmin(theta1, pi / 2 - 1e-15));
    }

  private:
    double inverse_width_;
};

class Curve final : public Isotropic {
  public:
    explicit Curve(const CurveLobe& lobe) : data_(lobe.shader().data) {
        std::vector<double> pieces;
        for (std::size_t i = 0; i < data_.size(); i += 2) pieces.push_back(data_[i]);
        shading_.data = data_.data();
        layer_.data_size = static_cast<int>(data_.size() / 2);
        set_pieces(1, std::move(pieces));
    }

    double density(dvec3 h) const override { return shading_.curve_lobe(layer_, h); }

    void densities(const DirectionColumns& h, double* p) const override {
        lobe_densities({kind_index<Lobe, CurveLobe>(), {}, data_.data(), layer_.data_size}, h, p);
    }

    std::vector<LobeParameterization> spans() const override {
        LobeParameterization above, below;
        below.flip = -1;
        for (const double theta : pieces_) {
            if (theta < pi / 2) above.breaks.push_back(theta);
            if (theta > pi / 2) below.breaks.push_back(pi - theta);
        }
        std::reverse(below.breaks.begin(), below.breaks.end());
        std::vector<LobeParameterization> spans;
        if (pieces_.front() < pi / 2) spans.push_back(above);
        if (pieces_.back() > pi / 2) spans.push_back(below);
        return spans;
    }

    std::unique_ptr<const LobeEnvelope> envelope() const override {
        return make_span_envelope(*this, [this](const LobeParameterization& span, const SpanCell& cell) {
            const double theta0 = std::acos(span.flip * (span.flip > 0 ? cell.t1 : cell.t0));
            return largest(theta0, std::acos(span.flip * (span.flip > 0 ? cell.t0 : cell.t1)));
        });
    }

  protected:
    double profile(double theta) const override { return density({std::sin(theta), 0, std::cos(theta)}); }

    double largest(double theta0, double theta1) const {
        double peak = std::fmax(profile(theta0), profile(theta1));
        for (std::size_t i = 0; i < data_.size(); i += 2)
            if (data_[i] >= theta0 && data_[i] <= theta1)
                peak = std::fmax(peak, static_cast<double>(data_[i + 1]));
        return peak;
    }

    double peak_over(double theta0, double theta1) const override {
        const double peak = largest(theta0, theta1);
        const double middle = theta0 < pi / 2 && theta1 > pi / 2 ? 1 : 0;
        return peak * std::fmax(std::fmax(std::sin(theta0), std::sin(theta1)), middle);
    }

  private:
    std::vector<float> data_;
    Shading<double> shading_;
    Shading<double>::Layer layer_{};
};

// The next float below where rounding would go up: a curve down to the horizon or to the nadir stays above
// it.
float rounded_down(double angle) {
    const float nearest = static_cast<float>(angle);
    return static_cast<double>(nearest) > angle ? std::nextafter(nearest, 0.0f) : nearest;
}

}  // namespace

std::shared_ptr<const LobeModel> InverseGaussianLobe::model() const {
    return std::make_shared<InverseGaussian>(*this);
}

std::shared_ptr<const LobeModel> CurveLobe::model() const { return std::make_shared<Curve>(*this); }

// Values over the power of two that brings the largest into [1, 2), so that no unit of p leaves a float's
// range: the lobe is normalised anyhow.
ShaderLobe CurveLobe::shader() const {
    double largest = 0;
    for (const auto& point : points) largest = std::fmax(largest, point.second);
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    ShaderLobe lobe{.data_size = static_cast<int>(points.size())};
    for (const auto& [theta, value] : points) {
        lobe.data.push_back(rounded_down(theta * (pi / 180)));
        lobe.data.push_back(static_cast<float>(std::scalbn(value, -exponent)));
    }
    return lobe;
}

}  // namespace nacre
