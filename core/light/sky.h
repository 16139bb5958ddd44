// A clear sky with its sun.
#pragma once

#include <glm/vec3.hpp>

namespace nacre {

// Preetham, Shirley and Smits (1999): the sky's luminance and chromaticity by Perez's five-parameter formula
// (their appendix A.2), and the sun's light after the atmosphere (A.1; ozone, mixed gases and vapour left
// out).
class ClearSky {
  public:
    // `sun` is a unit vector above the horizon (y > 0); `turbidity` 2 to 6: clear to hazy.
    ClearSky(glm::dvec3 sun, double turbidity);

    // kcd/m^2, linear Rec. 709 with that luminance, toward a unit direction above the horizon; without the
    // sun.
    glm::dvec3 radiance(glm::dvec3 direction) const;

    // klx on a surface that faces the sun, as above, of the sun alone.
    glm::dvec3 sun_illuminance() const;

  private:
    struct Perez {
        double a, b, c, d, e;
        double at(double cosine, double angle_to_sun) const;
    };

    glm::dvec3 sun_;
    double turbidity_;
    double theta_;  // of the sun, from the zenith
    Perez luminance_, x_, y_;
    glm::dvec3 zenith_;  // x, y, luminance, each over Perez's value there
};

}  // namespace nacre
