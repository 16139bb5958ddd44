// Oren and Nayar's functions of white facets (1994, eq. 27 and 28), and the sigma that brings them closest.
#pragma once

#include "core/model/shading.h"
#include "core/study/matt_sphere.h"

namespace nacre {

class OrenNayar {
  public:
    // Radians, the standard deviation of the facets' angles.
    explicit OrenNayar(double sigma);

    double full(glm::dvec3 k1, glm::dvec3 k2) const { return of_albedo(1, k1, k2); }

    // Without their interreflection, which grows as the square of the albedo.
    double once(glm::dvec3 k1, glm::dvec3 k2) const {
        return 4 * of_albedo(0.5, k1, k2) - of_albedo(1, k1, k2);
    }

  private:
    double of_albedo(double albedo, glm::dvec3 k1, glm::dvec3 k2) const;

    Shading<double>::ClosedForm form_{};
};

// Root mean square over pairs of directions drawn by their cosines, of 1/pi.
double apart(const RoundBrdf& a, const RoundBrdf& b);

// The sigma, radians, at which their single bounce is least apart from this one.
double closest_sigma(const RoundBrdf& first_bounce);

}  // namespace nacre
