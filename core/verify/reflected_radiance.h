// Radiance that a baked surface reflects toward the viewer under an environment: the reference for the
// preview.
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "core/bake/brdf.h"
#include "core/light/environment.h"
#include "core/verify/facet_ways.h"

namespace nacre {

// The integral over the hemisphere of rho(k1, k2) L(k1) (k1.n) dk1, W/(m^2 sr), by two quadratures that share
// it: over the picture's texels, where light is narrow, and over facets, dk1 = 4 (k2.h) dh, in the lobes' own
// coordinates, where p is. The balance heuristic (Veach & Guibas 1995) splits the integrand between them, so
// that each part is smooth at its own points. In double, without random numbers.
class RadianceIntegral {
  public:
    // `fineness` 1: 256 or more columns of light, half of the picture's own, and 96 x 96 facets for half a
    // lobe; the error falls with it, and the time grows with its square.
    RadianceIntegral(std::shared_ptr<const Tables> tables, std::shared_ptr<const Environment> environment,
                     int fineness);

    // `frame`: tangent, bitangent and normal in the environment's directions; k2 is local, above the horizon.
    dvec3 operator()(const glm::dmat3& frame, dvec3 k2) const;

  private:
    struct Light {
        dvec3 direction;
        dvec3 radiance;  // times the texel's solid angle
        double density, solid_angle;
    };
    struct View;

    dvec3 over_light(const View& view) const;
    dvec3 over_facets(const View& view, const FacetWay& way) const;

    std::shared_ptr<const Tables> tables_;
    std::shared_ptr<const Environment> environment_;
    int fineness_;
    std::vector<Light> lights_;
};

}  // namespace nacre
