// The tables of R of one distribution and one Fresnel model.
#pragma once

#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/area_table.h"

namespace nacre {

struct AlbedoTolerance {
    double rule_tolerance;   // see AlbedoQuadrature
    double probe_tolerance;  // the same for the directions between nodes by which the tables are measured
    int probes;              // at most, of those
};

// How the tables over one table of g are filled and measured, whatever their size. `material` holds the
// design but for the tables; `area` is kept as a reference.
class AlbedoSampling {
  public:
    AlbedoSampling(const AreaTable& area, const Shading<double>& material, int channels,
                   const AlbedoTolerance& effort)
        : area_(area),
          channels_(channels),
          shading_(area.shading(material)),
          nodes_(*area.distribution(), shading_, channels, effort.rule_tolerance),
          probes_(nodes_.finer(effort.probe_tolerance)),
          effort_(effort) {}
    AlbedoSampling(const AlbedoSampling&) = delete;
    AlbedoSampling& operator=(const AlbedoSampling&) = delete;

    const AreaTable& area() const { return area_; }
    const Shading<double>& shading() const { return shading_; }
    const AlbedoQuadrature& nodes() const { return nodes_; }
    const AlbedoQuadrature& probes() const { return probes_; }
    int most_probes() const { return effort_.probes; }
    int channels() const { return channels_; }
    AlbedoLayout layout() const { return {channels_, shading_.kinds.tint}; }

    // Lets both rules keep their tolerance at those directions too; whether they had to change.
    bool refine_at(const std::vector<dvec3>& directions) {
        const bool nodes = nodes_.refine_at(directions, effort_.rule_tolerance);
        return probes_.refine_at(directions, effort_.probe_tolerance) || nodes;
    }

  private:
    const AreaTable& area_;
    int channels_;  // Fresnel tables, see Needs
    Shading<double> shading_;
    AlbedoQuadrature nodes_, probes_;
    AlbedoTolerance effort_;
};

// R of one distribution at a direction.
struct KnownAlbedo {
    dvec3 k;
    AlbedoValues values;
};

class AlbedoTable {
  public:
    // On the grid of g's table, which is also where g(k2) is read. `rules` is kept as a reference.
    AlbedoTable(const AlbedoSampling& rules, TableNodes nodes, Workers& workers);
    AlbedoTable(const AlbedoTable&) = delete;
    AlbedoTable& operator=(const AlbedoTable&) = delete;

    // Error of R, absolute, every Fresnel factor: of the interpolation and of the rule, at the first
    // directions.
    AxisError measure() const;

    // Adds all directions between nodes that this table knows R at.
    void tell(std::vector<KnownAlbedo>& known) const;

    // Searches for errors larger than `error`, and more thoroughly where `error` is above `enough`;
    // adds to `error` what it finds and to `known` where it looked.
    void search(double enough, Search how, AxisError& error, std::vector<KnownAlbedo>& known,
                Workers& workers) const;

    // The worst error at those directions, and the worst of them.
    double worst_at(const std::vector<KnownAlbedo>& known) const;
    std::vector<dvec3> worst_of(const std::vector<KnownAlbedo>& known, std::size_t count) const;

    // R G/g with F = 1, then the Fresnel factors' differences, as the shader reads them; see AlbedoLayout.
    const std::vector<float>& data() const { return data_; }

    // Sets the shader's offsets for tables that begin at `offset` of its data.
    static void place(Shading<double>& shading, TableNodes nodes, int offset);

  private:
    void fill(Workers& workers);
    void probe(Workers& workers);
    std::vector<double> sample(const std::vector<TablePoint>& points, std::vector<KnownAlbedo>& known,
                               Workers& workers) const;
    std::vector<double> cell_bends_of_all() const;
    std::vector<TablePoint> layer_points(Workers& workers) const;
    dvec3 direction(const TablePoint& point) const;
    TableCells cells() const;

    const AlbedoSampling& rules_;
    TableNodes nodes_;
    int channels_;
    std::vector<float> data_;
    std::vector<double> kept_;  // clamped_part() at each node
    std::vector<float> read_;   // the table of g, then data_
    Shading<double> shading_;   // reads that
    std::vector<TablePoint> points_;
    std::vector<KnownAlbedo> probes_;
    std::vector<double> errors_;
};

}  // namespace nacre
