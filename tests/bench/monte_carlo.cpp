#include "tests/bench/monte_carlo.h"

#include <cmath>
#include <numbers>

namespace nacre::bench {

using std::numbers::pi;

namespace {

dvec2 both(double value, double cosine) {
    return {value, value * Shading<double>::schlick_weight(std::fmin(cosine, 1.0))};
}

}  // namespace

dvec2 AlbedoSampler::from_k2(const Shading<double>::Direction& k1, Random& random) const {
    const double z = 1 - uniform_random(random), phi = 2 * pi * uniform_random(random);
    const double sine = std::sqrt(1 - z * z);
    const dvec3 k2{sine * std::cos(phi), sine * std::sin(phi), z};
    const dvec3 h = glm::normalize(k1.k + k2);
    const double g2 = shading_.projected_area(k2, shading_.table_spot(k2));
    // rho c2 over 1/(2 pi)
    const double value = 0.5 * pi * shading_.density(h) *
                         shading_.visibility(k1, Shading<double>::known_direction(k2, g2, dvec3{0})) * k2.z;
    return both(value, glm::dot(k1.k, h));
}

// `weight` is (k1.h)+ p(h) over the density of h.
dvec2 AlbedoSampler::from_facet(const Shading<double>::Direction& k1, dvec3 h, double weight) const {
    const double cosine = glm::dot(k1.k, h);
    const dvec3 k2 = 2 * cosine * h - k1.k;
    if (k2.z <= 0 || weight <= 0) return dvec2{0};
    const double g2 = shading_.projected_area(k2, shading_.table_spot(k2));
    return both(weight * shading_.visibility(k1, Shading<double>::known_direction(k2, g2, dvec3{0})) * k2.z,
                cosine);
}

dvec2 AlbedoSampler::operator()(const Shading<double>::Direction& k1, Random& random) const {
    switch (sampling_) {
        case Sampling::uniform_hemisphere:
            break;
        case Sampling::visible_normals:
            return from_facet(k1, facets_.sample_visible(k1.k, random), k1.g);
        case Sampling::slopes: {
            const Facet facet = sample_slopes(shading_, random);
            return from_facet(k1, facet.h, glm::dot(k1.k, facet.h) * facet.mass);
        }
    }
    return from_k2(k1, random);
}

// Slopes with the density exp(-(X/sx)^2 - (Y/sy)^2)/(pi sx sy); a facet's solid angle is cos^3 of its slopes'
// area.
Facet sample_slopes(const Shading<double>& shading, Random& random) {
    const auto& layer = shading.layers[0];
    const dvec2 width = 1.0 / layer.inverse_width;
    const double radius = std::sqrt(-std::log(1 - uniform_random(random)));
    const double phi = 2 * pi * uniform_random(random);
    const dvec3 h =
        glm::normalize(dvec3{radius * std::cos(phi) * width.x, radius * std::sin(phi) * width.y, 1});
    return {h, layer.scale * pi * width.x * width.y * h.z * h.z * h.z};
}

}  // namespace nacre::bench
