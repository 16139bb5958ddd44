#include "core/fit/lobe_terms.h"

#include <cmath>
#include <numbers>

namespace nacre {

namespace {

// Beyond it exp(-q) is less than 2e-11 of the peak.
constexpr double q_max = 25;
// Directions closer than this to a lobe's own horizon send no light.
constexpr double cosine_min = 1e-4;

double squared_slope(const LobeFrame& lobe, const InFrame& k) {
    return (lobe.a22 * k.x * k.x - 2 * lobe.a12 * k.x * k.y + lobe.a11 * k.y * k.y) /
           (lobe.determinant() * k.z * k.z);
}

}  // namespace

void turn_frame(LobeFrame& lobe, glm::dvec3 N) {
    lobe.N = N;
    lobe.Y = glm::normalize(glm::dvec3(0, N.z, -N.y));
    lobe.X = glm::cross(lobe.Y, N);
}

// Cycles's: Walter et al. 2007 for GGX and their rational fit for Beckmann.
Lambda lobe_lambda(LobeShape shape, double s) {
    if (shape == LobeShape::ggx) {
        const double root = std::sqrt(1 + s);
        return {0.5 * (root - 1), 0.25 / root};
    }
    if (s < 0.39) return {0, 0};
    const double a = 1 / std::sqrt(s);
    const double top = 1 - 1.259 * a + 0.396 * a * a, bottom = 3.535 * a + 2.181 * a * a;
    const double slope_a = ((0.792 * a - 1.259) * bottom - top * (3.535 + 4.362 * a)) / (bottom * bottom);
    return {top / bottom, slope_a * -0.5 * a * a * a};
}

Kernel lobe_kernel(LobeShape shape, double q) {
    if (shape == LobeShape::ggx) return {1 / ((1 + q) * (1 + q)), -2 / (1 + q)};
    return {std::exp(-q), -1};
}

InFrame in_frame(const LobeFrame& lobe, glm::dvec3 k) {
    return {glm::dot(lobe.X, k), glm::dot(lobe.Y, k), glm::dot(lobe.N, k)};
}

bool lobe_terms(LobeShape shape, const LobeFrame& lobe, glm::dvec3 v, glm::dvec3 l, glm::dvec3 h,
                LobeTerms& terms) {
    const InFrame a = in_frame(lobe, h);
    if (a.z < cosine_min) return false;
    const double z2 = a.z * a.z;
    const double q = (lobe.a11 * a.x * a.x + 2 * lobe.a12 * a.x * a.y + lobe.a22 * a.y * a.y) / z2;
    if (shape == LobeShape::beckmann && q > q_max) return false;
    terms.v = in_frame(lobe, v);
    terms.l = in_frame(lobe, l);
    if (terms.v.z < cosine_min || terms.l.z < cosine_min) return false;
    terms.h = a;
    terms.q = q;
    terms.kernel = lobe_kernel(shape, q);
    terms.s_v = squared_slope(lobe, terms.v);
    terms.s_l = squared_slope(lobe, terms.l);
    terms.lambda_v = lobe_lambda(shape, terms.s_v);
    terms.lambda_l = lobe_lambda(shape, terms.s_l);
    const double D = terms.kernel.value * std::sqrt(lobe.determinant()) / (std::numbers::pi * z2 * z2);
    terms.bare = D / (4 * l.z * (1 + terms.lambda_v.value + terms.lambda_l.value));
    return true;
}

}  // namespace nacre
