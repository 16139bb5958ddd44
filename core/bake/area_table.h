// The table of g of one distribution.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/facet_changes.h"
#include "core/bake/stretched_grid.h"
#include "core/bake/table_points.h"
#include "core/bake/tables.h"
#include "core/bake/workers.h"
#include "core/bake/worst_search.h"

namespace nacre {

// g of one distribution at a direction.
struct KnownArea {
    dvec3 k;
    double g;
};

class AreaTable {
  public:
    // g at every node and at the directions between them by which it is measured, fewer of them for a draft.
    // without_moment: see `moment` in tables.glsl.
    AreaTable(std::shared_ptr<const FacetDistribution> distribution, const DistributionSymmetry& symmetry,
              TableNodes nodes, bool without_moment, Quality quality, Workers& workers);

    // The table of a distribution that has the same lobes in the same places: other weights, and in each lobe
    // that a brush has touched `changes`, the facets that were added (empty for all others). g is linear in
    // p, so it is only summed again and the changes are added to it, on directions that fitted the
    // distribution before. Differs from a new table by how well they fit now, which is measured.
    AreaTable(const AreaTable& before, std::shared_ptr<const FacetDistribution> distribution,
              const std::vector<std::vector<Facet>>& changes, Workers& workers);

    // `material` with this table in place of any other; reads data().
    Shading<double> shading(const Shading<double>& material) const;

    // Relative error between nodes under the material's clamp and N: see area_error().
    AxisError measure(const Shading<double>& material) const;

    // Adds all directions that this table knows g at.
    void tell(std::vector<KnownArea>& known) const;

    // Searches for errors larger than `error`, and more thoroughly where `error` is above `enough`;
    // adds to `error` what it finds and to `known` where it looked.
    void search(const Shading<double>& material, double enough, Search how, AxisError& error,
                std::vector<KnownArea>& known, Workers& workers) const;

    // The worst error at those directions.
    double worst_at(const Shading<double>& material, const std::vector<KnownArea>& known,
                    Workers& workers) const;

    const StretchedGrid& grid() const { return *grid_; }
    const std::shared_ptr<const FacetDistribution>& distribution() const { return distribution_; }

    // Rows of A, as the shader reads them.
    const std::vector<float>& data() const { return data_; }

  private:
    struct Sample {
        dvec3 k;
        TablePoint point;
    };

    void sample_nodes_and_between(Workers& workers);
    void sample_near_worst(Workers& workers);
    void add_samples(std::vector<Sample> added, Workers& workers);
    Sample sample_at(const TablePoint& point) const;
    void sample(std::size_t index);
    void fill();
    double area_at(std::size_t index) const;
    std::vector<double> node_weights(const Shading<double>& shading) const;
    TableCells cells() const;
    int strewn_directions() const;
    bool all_measured() const;
    std::size_t node_count() const;

    std::shared_ptr<const FacetDistribution> distribution_;
    TableNodes nodes_;
    Quality quality_;
    std::shared_ptr<const StretchedGrid> grid_;
    std::shared_ptr<const std::vector<Sample>> samples_;  // the nodes row by row, then what lies between
    std::vector<double> areas_;  // of each sample each lobe's own g, before its scale
    std::vector<float> data_;
};

}  // namespace nacre
