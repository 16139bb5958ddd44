// A plain grid of g, and of R where that is wanted.
#pragma once

#include <memory>
#include <vector>

#include "core/bake/bake.h"
#include "core/study/method.h"
#include "core/study/plain_grid.h"

namespace nacre {

// The steps of the paper's 200 points.
inline constexpr int paper_polar = 10, paper_azimuths = 20;

class GridTable {
  public:
    explicit GridTable(const PlainGrid& grid) : grid_(grid) {}

    double area(dvec3 k) const { return grid_.value(area_, k); }

    // area_of(node, k) is g.
    template <class AreaOf>
    void fill_area(const AreaOf& area_of, const std::stop_token& stop) {
        for (int node = 0; node < grid_.size(); ++node) {
            if (stop.stop_requested()) throw BakeCancelled();
            area_.push_back(static_cast<float>(area_of(node, grid_.direction(node))));
        }
    }

    // albedo_of(node, k, g) is R with F = 1 and with f0 = 0; g is the node's own, filled before.
    template <class AlbedoOf>
    void fill_albedo(const AlbedoOf& albedo_of, const std::stop_token& stop) {
        for (int node = 0; node < grid_.size(); ++node) {
            if (stop.stop_requested()) throw BakeCancelled();
            const AlbedoValues values = albedo_of(node, grid_.direction(node),
                                                  static_cast<double>(area_[static_cast<std::size_t>(node)]));
            full_.push_back(static_cast<float>(values[0]));
            zero_.push_back(static_cast<float>(values[1]));
        }
    }

    // The table as a method's result.
    static StoredTable stored(const std::shared_ptr<const GridTable>& table) {
        const std::size_t floats = table->area_.size() + table->full_.size() + table->zero_.size();
        return {.area = [table](dvec3 k) { return table->area(k); },
                .albedo =
                    [table](dvec3 k) {
                        return AlbedoValues{table->grid_.value(table->full_, k),
                                            table->grid_.value(table->zero_, k)};
                    },
                .bytes = floats * sizeof(float)};
    }

  private:
    PlainGrid grid_;
    std::vector<float> area_, full_, zero_;
};

}  // namespace nacre
