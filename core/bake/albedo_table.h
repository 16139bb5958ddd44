// The tables of R of one distribution and one Fresnel model.
#pragma once

#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/area_table.h"

namespace nacre {

struct AlbedoEffort {
    double rule_tolerance;   // see AlbedoRule
    double probe_tolerance;  // the same for the directions between nodes by which the tables are measured
    int probes;              // so many of those, at the most
};

// How the tables over one table of g are filled and measured, whatever their size. `material` holds the
// design but for the tables; `area` is kept as a reference.
class AlbedoRules {
  public:
    AlbedoRules(const AreaTable& area, const Shading<double>& material, int channels,
                const AlbedoEffort& effort)
        : area_(area),
          shading_(area.shading(material)),
          nodes_(*area.distribution(), shading_, channels, effort.rule_tolerance),
          probes_(nodes_.finer(effort.probe_tolerance)),
          most_probes_(effort.probes) {}
    AlbedoRules(const AlbedoRules&) = delete;
    AlbedoRules& operator=(const AlbedoRules&) = delete;

    const AreaTable& area() const { return area_; }
    const Shading<double>& shading() const { return shading_; }
    const AlbedoRule& nodes() const { return nodes_; }
    const AlbedoRule& probes() const { return probes_; }
    int most_probes() const { return most_probes_; }

  private:
    const AreaTable& area_;
    Shading<double> shading_;
    AlbedoRule nodes_, probes_;
    int most_probes_;
};

class AlbedoTable {
  public:
    // On the grid of g's table, which is also where g(k2) is read.
    AlbedoTable(const AlbedoRules& rules, const BakePlan& plan, Workers& workers);

    // Error of R, absolute, every Fresnel factor: of the interpolation and of the rule.
    const AxisError& error() const { return error_; }

    // R G/g with F = 1, then the Fresnel factors' differences, as the shader reads them.
    const std::vector<float>& data() const { return data_; }

    // Tells the shader that these tables begin at `offset` of its data.
    static void place(Shading<double>& shading, const BakePlan& plan, int offset);

  private:
    void measure(const AlbedoRules& rules, const BakePlan& plan, Workers& workers);

    std::vector<float> data_;
    AxisError error_;
};

}  // namespace nacre
