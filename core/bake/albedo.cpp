#include "core/bake/albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

void add(AlbedoValues& sum, const AlbedoValues& values, double weight) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * values[i];
}

// The interval cut at p's corners.
template <class Visit>
void for_each_part(LobeWalk::Interval interval, const std::vector<double>& breaks, const Visit& visit) {
    double begin = interval.begin;
    for (const double at : breaks) {
        if (at <= begin || at >= interval.end) continue;
        visit(begin, at);
        begin = at;
    }
    if (interval.end > begin) visit(begin, interval.end);
}

}  // namespace

LobeWalk::LobeWalk(const PlacedLobe& placed, const LobeSpan& span, dvec3 k1)
    : placed_(placed), span_(span), k1_(k1), axis_(placed.frame[2] * span.flip) {
    const dvec3 own = glm::transpose(placed.frame) * k1;
    start_ = std::atan2(span.stretch.y * own.y, span.stretch.x * own.x) - pi / 2;
}

dvec3 LobeWalk::along(double psi) const {
    return placed_.frame[0] * (span_.stretch.x * std::cos(psi)) +
           placed_.frame[1] * (span_.stretch.y * std::sin(psi));
}

// Facets h = s e + t a (s, t = sin and cos of chi; not normalised) send k1 above the horizon where
//   2 (k1.h)(n.h) - (k1.n) |h|^2 = m + r cos(2 chi - delta) > 0  and  n.h > 0.
// That is a disk in the slopes about n, so a great circle meets it in one interval.
LobeWalk::Interval LobeWalk::interval(double psi) const {
    const dvec3 e = along(psi);
    const double ke = glm::dot(k1_, e), ka = glm::dot(k1_, axis_);
    const double alpha = 2 * ke * e.z - k1_.z * glm::dot(e, e);
    const double beta = ke * axis_.z + ka * e.z;
    const double gamma = 2 * ka * axis_.z - k1_.z;
    const double m = 0.5 * (alpha + gamma), x = 0.5 * (gamma - alpha);
    const double r = std::hypot(x, beta);
    if (r <= std::fabs(m) && m <= 0) return {0, 0};
    const double reach = r > 0 ? 0.5 * std::acos(std::clamp(-m / r, -1.0, 1.0)) : 0.5 * pi;
    double middle = 0.5 * std::atan2(beta, x);
    if (std::sin(middle) * e.z + std::cos(middle) * axis_.z < 0) middle += middle > 0 ? -pi : pi;
    return {std::clamp(middle - reach, 0.0, pi / 2), std::clamp(middle + reach, 0.0, pi / 2)};
}

Facet LobeWalk::facet(double psi, double chi) const {
    const double s = std::sin(chi), t = std::cos(chi);
    const dvec3 own{span_.stretch.x * s * std::cos(psi), span_.stretch.y * s * std::sin(psi), t};
    const double length = glm::length(own);
    dvec3 h = own / length;
    h.z *= span_.flip;
    const double solid_angle = span_.stretch.x * span_.stretch.y * s / (length * length * length);
    return {placed_.frame * h, placed_.scale * placed_.lobe->density(h) * solid_angle};
}

AlbedoRule::AlbedoRule(const FacetDistribution& distribution, bool fine)
    : distribution_(distribution), fine_(fine), facets_(distribution.facets(fine ? 4096 : 256)) {}

AlbedoValues AlbedoRule::operator()(const Shading<double>& shading, dvec3 k1, double g1, int channels) const {
    AlbedoValues sum{};
    const FacetAlbedo albedo{shading, k1, g1, channels};
    const auto& rule = fine_ ? gauss_legendre<32>() : gauss_legendre<7>();
    auto area = [&](dvec3 k) { return shading.projected_area(k, shading.table_spot(k)); };
    auto add_span = [&](const LobeWalk& walk) {
        for (int i = 0; i < 2 * static_cast<int>(rule.size()); ++i) {
            const QuadraturePoint& a = rule[static_cast<std::size_t>(i / 2)];
            const double psi = walk.start() + pi * (i % 2 + a.x);
            for_each_part(walk.interval(psi), walk.breaks(), [&](double begin, double end) {
                for (const QuadraturePoint& b : rule) {
                    const Facet facet = walk.facet(psi, begin + (end - begin) * b.x);
                    if (facet.mass <= 0) continue;
                    add(sum, albedo(facet.h, area), pi * a.weight * (end - begin) * b.weight * facet.mass);
                }
            });
        }
    };
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const PlacedLobe& placed = distribution_.lobes()[i];
        for (const Facet& facet : facets_[i]) add(sum, albedo(facet.h, area), facet.mass);
        for (const LobeSpan& span : placed.lobe->spans()) add_span(LobeWalk(placed, span, k1));
    }
    return sum;
}

}  // namespace nacre
