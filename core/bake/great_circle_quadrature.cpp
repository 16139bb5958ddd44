#include "core/bake/great_circle_quadrature.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bake/great_circle_quadrature.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include "core/model/lane_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

using Real = LaneReals<Doubles>;

// h' = (sin(chi) cos(psi), sin(chi) sin(psi), cos(chi)) of the stretched hemisphere to h = A h'/|A h'|, into
// x, y and z, and into `area` what a step of psi and chi covers: det(A) sin(chi)/|A h'|^3 steradians.
HWY_FLATTEN HWY_ATTR void stretch_points(dvec2 stretch, const double* cosine, const double* sine,
                                         const double* chi, std::size_t count, double* x, double* y,
                                         double* z, double* area) {
    const Doubles d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const std::size_t rest = count - i;
        const auto angle = load(chi + i, rest);
        const Real s(hn::Sin(d, angle.v)), t(hn::Cos(d, angle.v));
        const Real a = s * stretch.x * load(cosine + i, rest), b = s * stretch.y * load(sine + i, rest);
        const Real unit = Real(1.0) / sqrt(a * a + b * b + t * t);
        store(a * unit, x + i, rest);
        store(b * unit, y + i, rest);
        store(t * unit, z + i, rest);
        store(s * (stretch.x * stretch.y) * unit * unit * unit, area + i, rest);
    }
}

// The points where p is not 0, from the lobe's frame to the surface's, each with the mass of its facets; how
// many there are. Of a column so many numbers past the last may be written as a vector holds.
HWY_FLATTEN HWY_ATTR std::size_t place_facets(const PlacedLobe& placed, const DirectionColumns& own,
                                              const double* p, const double* area, const double* weight,
                                              double* x, double* y, double* z, double* mass) {
    const Doubles d;
    const dvec3 a = placed.frame[0], b = placed.frame[1], c = placed.frame[2];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < own.size; i += hn::Lanes(d)) {
        const std::size_t rest = own.size - i;
        const auto density = load(p + i, rest);
        const auto some = (density > Real(0.0)).m;
        const auto hx = load(own.x + i, rest), hy = load(own.y + i, rest), hz = load(own.z + i, rest);
        hn::CompressStore((hx * a.x + hy * b.x + hz * c.x).v, some, d, x + kept);
        hn::CompressStore((hx * a.y + hy * b.y + hz * c.y).v, some, d, y + kept);
        hn::CompressStore((hx * a.z + hy * b.z + hz * c.z).v, some, d, z + kept);
        const auto all = load(weight + i, rest) * placed.scale * density * load(area + i, rest);
        kept += hn::CompressStore(all.v, some, d, mass + kept);
    }
    return kept;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(stretch_points);
HWY_EXPORT(place_facets);

using std::numbers::pi;

namespace {
// From this cosine of k1 up no layer is so thin that a rule of integration could miss it.
constexpr double layer_below = 0.1;
}  // namespace

GreatCircleQuadrature::GreatCircleQuadrature(const PlacedLobe& placed, const LobeParameterization& span,
                                             dvec3 k1)
    : placed_(placed), span_(span), k1_(k1), axis_(placed.frame[2] * span.flip), across_(-k1.y, k1.x, 0) {
    const dvec3 own = glm::transpose(placed.frame) * k1;
    start_ = std::atan2(span.stretch.y * own.y, span.stretch.x * own.x) - pi / 2;
}

GreatCircleQuadrature::Ray GreatCircleQuadrature::ray(double psi) const {
    return interval(std::cos(psi), std::sin(psi), 0);
}

// Facets h = s e + t a (s, t = sin and cos of chi; not normalised) send k1 to c2 > least c1 where
//   2 (k1.h)(n.h) - (1 + least) (k1.n) |h|^2 = m + r cos(2 chi - delta) > 0  and  n.h > 0.
// That is a disk in the slopes about n, so a great circle meets it in one interval.
GreatCircleQuadrature::Ray GreatCircleQuadrature::interval(double cosine, double sine, double least) const {
    Ray ray{cosine, sine, 0, 0};
    const dvec3 e = ray_direction(ray.cosine, ray.sine);
    const double ke = glm::dot(k1_, e), ka = glm::dot(k1_, axis_), c = (1 + least) * k1_.z;
    const double alpha = 2 * ke * e.z - c * glm::dot(e, e);
    const double beta = ke * axis_.z + ka * e.z;
    const double gamma = 2 * ka * axis_.z - c;
    const double m = 0.5 * (alpha + gamma), x = 0.5 * (gamma - alpha);
    const double r = std::hypot(x, beta);
    if (r <= std::fabs(m) && m <= 0) return ray;
    const double reach = r > 0 ? 0.5 * std::acos(std::clamp(-m / r, -1.0, 1.0)) : 0.5 * pi;
    double middle = 0.5 * std::atan2(beta, x);
    if (std::sin(middle) * e.z + std::cos(middle) * axis_.z < 0) middle += middle > 0 ? -pi : pi;
    ray.begin = std::clamp(middle - reach, 0.0, pi / 2);
    ray.end = std::clamp(middle + reach, 0.0, pi / 2);
    return ray;
}

std::vector<double> GreatCircleQuadrature::azimuth_cuts(MaskingBends bends) const {
    if (bends != MaskingBends::azimuth) return {0, 1, 2};
    const double psi =
        std::atan2(-glm::dot(ray_direction(1, 0), across_), glm::dot(ray_direction(0, 1), across_));
    const double after = std::remainder(psi - start_, pi) / pi, plane = after < 0 ? after + 1 : after;
    return {0, plane, 1, 1 + plane, 2};
}

void GreatCircleQuadrature::cuts(const Ray& ray, MaskingBends bends, std::vector<double>& all) const {
    all.assign(1, ray.begin);
    auto add = [&](double at) {
        if (at > ray.begin && at < ray.end) all.push_back(at);
    };
    for (const double at : span_.breaks) add(at);
    if (bends == MaskingBends::azimuth) {
        const double along = glm::dot(ray_direction(ray.cosine, ray.sine), across_);
        add(std::atan2(-glm::dot(axis_, across_) * std::copysign(1.0, along), std::fabs(along)));
    }
    if (bends != MaskingBends::none && k1_.z < layer_below)
        for (const double least : {1.0, 4.0}) {
            const Ray inner = interval(ray.cosine, ray.sine, least);
            if (inner.end <= inner.begin) continue;
            add(inner.begin);
            add(inner.end);
        }
    all.push_back(ray.end);
    std::sort(all.begin(), all.end());
}

Facet GreatCircleQuadrature::facet(const Ray& ray, double chi) const {
    dvec3 h;
    double area = 0;
    HWY_DYNAMIC_DISPATCH(stretch_points)
    (span_.stretch, &ray.cosine, &ray.sine, &chi, 1, &h.x, &h.y, &h.z, &area);
    h.z *= span_.flip;
    return {placed_.frame * h, placed_.scale * placed_.lobe->density(h) * area};
}

void GreatCircleQuadrature::add_facets(const WalkPoints& points, WeightedDirections& facets) const {
    constexpr std::size_t past = 64;  // no vector of an x86 or ARM processor holds more
    const std::size_t count = points.chi.size(), before = facets.size();
    std::vector<double> columns(5 * count);
    double *x = columns.data(), *y = x + count, *z = y + count, *area = z + count, *p = area + count;
    HWY_DYNAMIC_DISPATCH(stretch_points)
    (span_.stretch, points.cosine.data(), points.sine.data(), points.chi.data(), count, x, y, z, area);
    if (span_.flip < 0) std::transform(z, z + count, z, std::negate());
    const DirectionColumns own{x, y, z, count};
    placed_.lobe->densities(own, p);
    facets.resize(before + count + past);
    const std::size_t kept = HWY_DYNAMIC_DISPATCH(place_facets)(
        placed_, own, p, area, points.weight.data(), facets.x() + before, facets.y() + before,
        facets.z() + before, facets.weight() + before);
    facets.resize(before + kept);
}

}  // namespace nacre
#endif
