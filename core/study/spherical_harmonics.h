// Real spherical harmonics, as far as a convolution with max(0, cos) needs them: the degrees 0, 1 and every
// even one; of the other degrees it leaves nothing.
#pragma once

#include <vector>

#include "core/model/lobe.h"

namespace nacre {

// Indexing of the harmonics up to `degree`; with `round`, only those that do not depend on azimuth.
class HarmonicBasis {
  public:
    HarmonicBasis(int degree, bool round);

    int degree() const { return degree_; }
    std::size_t size() const { return degrees_.size(); }
    int degree_of(std::size_t index) const { return degrees_[index]; }

    // Orthonormal on the sphere, into `values`, which has size(). |h| = 1.
    void evaluate(dvec3 h, std::vector<double>& values) const;

  private:
    // From the two degrees below: P(l,m) = a z P(l-1,m) - b P(l-2,m).
    struct Step {
        double a, b;
        int stored;  // index of the harmonic with cos(m phi), before that with sin(m phi); -1: of an odd
                     // degree
    };

    int degree_;
    int orders_;
    std::vector<Step> steps_;  // by order, then by degree
    std::vector<double> diagonal_;
    std::vector<int> degrees_;
};

// What a convolution with max(0, cos) multiplies a harmonic of degree l by: pi, 2 pi/3, pi/4, 0, -pi/24, ...
// (Ramamoorthi & Hanrahan 2001, An efficient representation for irradiance environment maps)
double clamped_cosine_factor(int degree);

}  // namespace nacre
