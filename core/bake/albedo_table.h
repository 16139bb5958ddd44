// The tables of R of one distribution and one Fresnel model.
#pragma once

#include <vector>

#include "core/bake/area_table.h"

namespace nacre {

struct AlbedoEffort {
    double rule_tolerance;   // see AlbedoRule
    double probe_tolerance;  // the same for the directions between nodes by which the tables are measured
    int probes;              // so many of those, at the most
};

class AlbedoTable {
  public:
    // On the grid of `area`, which is also where g(k2) is read. `material` holds the design but for the
    // tables.
    AlbedoTable(const AreaTable& area, const Shading<double>& material, const BakePlan& plan,
                const AlbedoEffort& effort, Workers& workers);

    // Error of R, absolute, every Fresnel factor: of the interpolation and of the rule.
    const AxisError& error() const { return error_; }

    // R G/g with F = 1, then the Fresnel factors' differences, as the shader reads them.
    const std::vector<float>& data() const { return data_; }

    // Tells the shader that these tables begin at `offset` of its data.
    static void place(Shading<double>& shading, const BakePlan& plan, int offset);

  private:
    void measure(const AreaTable& area, Shading<double> shading, const BakePlan& plan,
                 const AlbedoEffort& effort, Workers& workers);

    std::vector<float> data_;
    AxisError error_;
};

}  // namespace nacre
