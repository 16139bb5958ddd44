// Tables of g and R, sized for a given error.
#pragma once

#include "core/bake/albedo_table.h"
#include "core/bake/bake.h"

namespace nacre {

// A table, its largest measured error, and all sizes that were tried.
struct FittedArea {
    std::shared_ptr<const AreaTable> table;
    AxisError error;
    TableNodes nodes;
    std::vector<TriedSize> tried;
};

struct FittedAlbedo {
    std::vector<float> data;  // see AlbedoTable
    TableError error;
    TableNodes nodes;
    std::vector<TriedSize> tried;
};

// From options.size or first_size() on; material holds the design but for its tables.
FittedArea fit_area(const std::shared_ptr<const FacetDistribution>& distribution, const Needs& needs,
                    const BakeOptions& options, const Shading<double>& material, Workers& workers);

// The same over a table of g, whose error is given.
FittedAlbedo fit_albedo(const AreaTable& area, const AxisError& area_error, const Needs& needs,
                        const BakeOptions& options, const Shading<double>& material, Workers& workers);

}  // namespace nacre
