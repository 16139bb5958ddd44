// A design as the tables of a measured material (Dupuy and Jakob 2018): readers evaluate
//
//   rho(wi, wo) cos(theta_o) = values(u; wi) ndf(m) / (4 sigma(wi)),   m the half vector,
//
// where u is the point of the unit square that the warp of visible normals takes to m. Places in ndf, sigma
// and the warp are x = sqrt(2 theta/pi), y = (phi + pi)/(2 pi), nodes on both ends.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/bake/tables.h"
#include "core/formats/square_density.h"

namespace nacre {

struct RglSize {
    int azimuths;        // of the incident direction: 1 where the design is isotropic
    int elevations;      // of it
    glm::ivec2 normals;  // of ndf: along theta, along phi
    glm::ivec2 areas;    // of sigma, the same
    glm::ivec2 warp;     // of each incident direction
    glm::ivec2 values;   // of each incident direction

    std::size_t incident() const;
};

struct RglTables {
    RglSize size;
    std::vector<double> phi, theta;   // of the incident direction, radians, rising
    std::vector<float> ndf, sigma;    // rows along phi
    std::vector<SquareDensity> warp;  // of each incident direction, elevations first
    std::vector<glm::vec3> values;    // the same, rows of each; linear Rec. 709
    std::vector<float> luminance;     // the same: what readers draw points of the square by

    bool isotropic() const { return phi.size() == 1; }
    std::size_t values_of(std::size_t incident) const {
        return incident * static_cast<std::size_t>(size.values.x * size.values.y);
    }
    double sigma_at(dvec3 wi) const;  // as a reader has it

    // rho cos(theta_o), as a reader makes it of them; unit vectors above the horizon.
    dvec3 evaluate(dvec3 wi, dvec3 wo) const;
};

// Throws BakeCancelled soon after `stop` is requested.
RglTables rgl_tables(const Tables& tables, const RglSize& size, const std::stop_token& stop);

}  // namespace nacre
