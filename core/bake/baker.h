// Bakes one design after another, and only what has changed.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/bake/albedo_table.h"
#include "core/bake/bake.h"
#include "core/bake/bounce_tables.h"
#include "core/bake/coat_tables.h"
#include "core/bake/facet_tables.h"

namespace nacre {

// How a table was made: rebuilt; updated from each lobe's own g and what a brush added; or reused.
enum class TableOrigin { rebuilt, updated, reused };

// One worker's memory of its last designs. A final bake gives the same bits as bake() whatever was baked
// before: it keeps a table only where nothing that the table reads has changed (a colour; with Schlick's
// Fresnel, f0). A draft also sums g again, on the directions of the draft before, after a change of weights
// or a touch of the brush; its measured error includes the effect.
class Baker {
  public:
    // As bake(), see bake/bake.h. `p`: the design's, where it is made already.
    std::shared_ptr<const Tables> bake(const Design& design, const BakeOptions& options = {},
                                       std::stop_token stop = {},
                                       const std::function<void(double)>& progress = {},
                                       std::shared_ptr<const FacetDistribution> p = {});

    // Of the last bake; R counts as kept where the design needs none.
    TableOrigin area_origin() const { return area_origin_; }
    TableOrigin albedo_origin() const { return albedo_origin_; }

  private:
    struct KeptArea {
        std::shared_ptr<const AreaTable> table = {};  // of p, or of its facets merged
        TableNodes nodes{};
        AxisError error = {};
        double fitted_error = 0;  // worst of g when the grid was fitted to p
        std::vector<TriedSize> tried = {};
        double seconds = 0;  // that it took to make
    };
    struct KeptAlbedo {
        std::shared_ptr<const std::vector<float>> data = {};  // see AlbedoTable; null where R is not needed
        TableNodes nodes{};
        TableError error = {};
        std::vector<TriedSize> tried = {};
        double seconds = 0;
    };
    // The last tables of one quality and what they were made for.
    struct Kept {
        Design design = {};
        BakeOptions options = {};
        Needs needs = {};
        std::shared_ptr<const FacetDistribution> distribution = {};
        KeptArea area = {};
        KeptAlbedo albedo = {};
        std::optional<BounceFit> bounces = {};
        std::optional<FacetTables> facets = {};
        std::optional<CoatLobe> coat = {};
    };

    // The new p against the one before.
    struct Followed {
        std::shared_ptr<const FacetDistribution> distribution;
        std::vector<std::vector<Facet>> changes;  // of each lobe, what a brush has added
        bool same_lobes = false;                  // in the same places but for the changes
    };

    Followed follow(const Distribution& distribution, std::shared_ptr<const FacetDistribution> p) const;
    std::shared_ptr<const FacetDistribution> make(const Distribution& distribution) const;
    const PlacedLobe* lobe_before(std::size_t layer) const;
    KeptArea make_area(const Kept& made, const Followed& now, const Shading<double>& material,
                       Workers& workers);
    std::optional<KeptArea> sum_area(const Kept& made, const Followed& now, const Shading<double>& material,
                                     Workers& workers) const;
    void choose_tables(Kept& made, const std::optional<Kept>& before, const Followed& now,
                       const Shading<double>& material, Workers& workers);
    static KeptAlbedo make_albedo(const Kept& made, const Shading<double>& material, Workers& workers);

    static void assemble(Kept& made, Tables& tables, Workers& workers);
    static void add_albedo(const Kept& made, Tables& tables);
    static void integrate(const Kept& made, Tables& tables, Workers& workers);

    Distribution before_;  // what distribution_ was made from
    std::shared_ptr<const FacetDistribution> distribution_;
    std::optional<Kept> draft_, final_;
    TableOrigin area_origin_ = TableOrigin::rebuilt, albedo_origin_ = TableOrigin::rebuilt;
};

}  // namespace nacre
