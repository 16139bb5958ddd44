// The directions of the tables: see shaders/shared/tables.glsl for the map from k to (w, psi).
#pragma once

#include "core/bake/symmetry.h"
#include "core/bake/table_size.h"
#include "core/model/facet_distribution.h"
#include "core/model/shading.h"

namespace nacre {

// cot(theta) at v in (0, 1], a = 2 |L e|/g(n).
double cotangent_at_v(double v, double a);

// cos and sin of phi, from the tables' axis, at rho in [0, 4], quarter turns; `shading` holds the tables'
// shape.
dvec2 azimuth_at_rho(double rho, const Shading<double>& shading);

// psi or rho at a row or between two rows, quarter turns.
double row_turns(double row, int nodes, Symmetry symmetry);

// k, or where k is n itself the direction just beside it on the tables' axis, toward which R is meant there:
// a masking that is correlated by azimuth has another limit at n from every side.
dvec3 beside_normal(dvec3 k, dvec2 axis);

class StretchedGrid {
  public:
    // Measures p: g(n), its width D(phi) at grazing, the ellipse of that width and the tilt of p;
    // its moment, where that is to be left out of the table.
    StretchedGrid(const FacetDistribution& distribution, const DistributionSymmetry& symmetry, int nodes_psi,
                  bool without_moment);

    // The fields of the shader's table shape that do not depend on where the tables lie.
    const Shading<double>::TableShape& shape() const { return shading_.surface.tables; }

    Symmetry symmetry() const { return symmetry_; }

    // The direction at (w, psi) of the area's table or at (v, rho) of the albedo's, w and v in [0, 1]; rows
    // as in the tables, also between nodes.
    dvec3 area_direction(double w, double row) const;
    dvec3 albedo_direction(double v, double row, int nodes_rho) const;

    // A at k, from g there.
    double shape_value(dvec3 k, double g) const {
        return (g - glm::dot(dvec2(k), shape().moment)) / spot(k).scale;
    }

  private:
    void fit_ellipse(const FacetDistribution& distribution, double axis);
    dvec2 area_azimuth(double row) const;         // cos and sin of phi
    dvec2 turned(dvec2 azimuth) const;            // from the axis to the surface's frame
    double cotangent_scale(dvec2 azimuth) const;  // 2 |L e|/g(n)
    Shading<double>::TableSpot spot(dvec3 k) const;

    Symmetry symmetry_;
    Shading<double> shading_;  // of which only the tables are described
};

}  // namespace nacre
