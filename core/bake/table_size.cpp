#include "core/bake/table_size.h"

#include <array>
#include <cmath>

namespace nacre {
namespace {

// Cells along an axis, each a fifth or so more than the last; multiples of four, so that a full turn's rows
// stand on every quarter.
constexpr std::array<int, 30> steps = {8,   12,  16,  20,  24,  28,  32,   40,   48,   56,
                                       64,  72,  80,  88,  96,  112, 128,  160,  192,  224,
                                       256, 320, 384, 448, 512, 768, 1024, 1536, 2048, 3072};

// Rows for a number of cells: a full turn closes on its first row.
int rows(int cells, Symmetry symmetry) {
    if (symmetry == Symmetry::isotropic) return 1;
    return symmetry == Symmetry::none ? cells : cells + 1;
}

}  // namespace

TableSize first_size(Symmetry symmetry, Quality quality) {
    const bool draft = quality == Quality::draft;
    switch (symmetry) {
        case Symmetry::isotropic:
            return draft ? TableSize{33, 1, 33, 1} : TableSize{25, 1, 33, 1};
        case Symmetry::quarter:
            return draft ? TableSize{17, 9, 17, 9} : TableSize{25, 9, 25, 13};
        case Symmetry::half:
            return draft ? TableSize{17, 17, 17, 17} : TableSize{25, 17, 25, 25};
        case Symmetry::none:
            break;
    }
    return draft ? TableSize{17, 24, 17, 24} : TableSize{25, 32, 25, 32};
}

int azimuth_cells(int nodes, Symmetry symmetry) {
    return symmetry == Symmetry::none || nodes == 1 ? nodes : nodes - 1;
}

TableNodes better_nodes(TableNodes now, Symmetry symmetry, double error_polar, double error_azimuth,
                        double target, int limit) {
    const bool flat = symmetry == Symmetry::isotropic;
    const int old_polar = now.polar - 1, old_azimuth = azimuth_cells(now.azimuth, symmetry);
    auto expected = [](double error, int before, int after) {
        const double ratio = static_cast<double>(before) / after;
        return error * ratio * ratio;
    };
    TableNodes best = now;
    double best_error = error_polar + error_azimuth;
    for (const int polar : steps) {
        for (const int azimuth : steps) {
            if (polar > 4 * old_polar || (!flat && azimuth > 4 * old_azimuth)) continue;
            const TableNodes nodes{polar + 1, rows(azimuth, symmetry)};
            const int count = nodes.polar * nodes.azimuth, best_count = best.polar * best.azimuth;
            if (count > limit) continue;
            const double error = expected(error_polar, old_polar, polar) +
                                 (flat ? 0 : expected(error_azimuth, old_azimuth, azimuth));
            const bool good = error <= target, best_good = best_error <= target;
            if (good ? !best_good || count < best_count : !best_good && error < best_error) {
                best = nodes;
                best_error = error;
            }
        }
    }
    return best;
}

}  // namespace nacre
