// R(k) by Monte Carlo, as the paper computes it: what the bake's rule is compared with.
#pragma once

#include "core/bake/albedo.h"

namespace nacre::bench {

enum class Sampling {
    uniform_hemisphere,  // of k2, the paper's own
    visible_normals,     // Heitz & d'Eon 2014, exact for every p
    slopes               // sample_slopes()
};

// One value a sample; the mean of many is the integral.
class AlbedoSampler {
  public:
    // g is read from the tables that `shading` holds, as the bake's rule does.
    AlbedoSampler(const FacetDistribution& facets, const Shading<double>& shading, Sampling sampling)
        : facets_(facets), shading_(shading), sampling_(sampling) {}

    // R with F = 1, and with Schlick's weight.
    dvec2 operator()(const Shading<double>::Direction& k1, Random& random) const;

  private:
    dvec2 from_k2(const Shading<double>::Direction& k1, Random& random) const;
    dvec2 from_facet(const Shading<double>::Direction& k1, dvec3 h, double weight) const;

    const FacetDistribution& facets_;
    const Shading<double>& shading_;
    Sampling sampling_;
};

// A facet of a single upright Gaussian (eq. 34), drawn by its slopes; mass = p over the density it is drawn
// with.
Facet sample_slopes(const Shading<double>& shading, Random& random);

// Mean and variance of a sample, of the worse component.
struct Moments {
    dvec2 sum{0}, squares{0};
    double count = 0;

    void add(dvec2 value) {
        sum += value;
        squares += value * value;
        count += 1;
    }
    dvec2 mean() const { return sum / count; }
    double variance() const {
        const dvec2 v = squares / count - mean() * mean();
        return v.x > v.y ? v.x : v.y;
    }
};

}  // namespace nacre::bench
