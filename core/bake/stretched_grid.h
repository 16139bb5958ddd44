// The directions of the tables: see shaders/shared/tables.glsl for the map from k to (w, psi).
#pragma once

#include <vector>

#include "core/bake/plan.h"
#include "core/model/facet_distribution.h"

namespace nacre {

// cot(theta) at v in (0, 1], a = 2 D/Mz.
double cotangent_at_v(double v, double a);

// cos and sin of phi, from the tables' axis, at psi or at rho, both in quarter turns, [0, 4].
dvec2 azimuth_at_psi(double psi, dvec2 stretch);
dvec2 azimuth_at_rho(double rho, dvec2 stretch);

class StretchedGrid {
  public:
    // Measures p: its moment above the horizon, its width D(phi) at grazing, and the ellipse of that width.
    StretchedGrid(const FacetDistribution& distribution, const BakePlan& plan);

    // The fields of the shader's table shape that do not depend on where the tables lie.
    const Shading<double>::TableShape& shape() const { return shading_.surface.tables; }

    // D(phi)/|L e(phi)| at each row.
    const std::vector<float>& widths() const { return data_; }

    // The direction at (w, psi) of the area's table or at (v, rho) of the albedo's, w and v in [0, 1]; rows
    // as in the tables, also between nodes.
    dvec3 area_direction(double w, double row) const;
    dvec3 albedo_direction(double v, double row) const;

    // A at (w, psi), from g there.
    double shape_value(double w, double row, double g) const;

  private:
    double width(double phi) const;
    void fit_ellipse(const DistributionSymmetry& symmetry);
    double row_turns(double row, int nodes) const;  // psi or rho at a row, quarter turns
    dvec2 area_azimuth(double row) const;           // cos and sin of phi
    dvec2 albedo_azimuth(double row) const;
    dvec2 turned(dvec2 azimuth) const;          // from the axis to the surface's frame
    double ellipse(dvec2 azimuth) const;        // |L e|
    double grazing_width(dvec2 azimuth) const;  // D as the tables hold it

    const FacetDistribution& distribution_;
    Symmetry symmetry_;
    int nodes_psi_, nodes_rho_;
    dvec3 moment_;
    dvec2 axis_{1, 0};
    dvec2 stretch_{1};
    std::vector<float> data_;  // the widths
    Shading<double> shading_;  // reads them as the shader does
};

}  // namespace nacre
