// Integrals over the hemisphere of what the finished tables of R hold, cell by cell of them.
#pragma once

#include <numbers>
#include <vector>

#include "core/bake/direction_sums.h"
#include "core/bake/workers.h"
#include "core/model/quadrature.h"
#include "core/model/shading.h"

namespace nacre {

// Directions of one azimuth, cell by cell of the tables, weighted for the integral over theta of f cos sin.
WeightedDirections meridian(const Shading<double>& shading, double phi);

// phi of each row of R's tables, first to last: between two of them the interpolant is smooth but for the
// rows of g.
std::vector<double> row_azimuths(const Shading<double>& shading);

// The integral of f(k) c dk; sum_of(directions) is the weighted sum of f. `tolerance`: absolute, of what lies
// between two rows. Throws BakeCancelled.
template <std::size_t Size, class SumOf>
Values<Size> integrate_tables(const Shading<double>& shading, double tolerance, Workers& workers,
                              const SumOf& sum_of) {
    using std::numbers::pi;
    Values<Size> sum{};
    double covered = 1;
    if (shading.surface.tables.symmetry == Shading<double>::SYMMETRY_ISOTROPIC) {
        sum = sum_of(meridian(shading, 0));
    } else {
        const std::vector<double> azimuths = row_azimuths(shading);
        covered = azimuths.back() - azimuths.front();
        std::vector<Values<Size>> parts(azimuths.size() - 1);
        workers.for_each(static_cast<int>(parts.size()), [&](int i) {
            const std::size_t at = static_cast<std::size_t>(i);
            parts[at] = integrate_adaptively<Size>([&](double phi) { return sum_of(meridian(shading, phi)); },
                                                   azimuths[at], azimuths[at + 1], tolerance, 12);
        });
        for (const Values<Size>& part : parts)
            for (std::size_t j = 0; j < Size; ++j) sum[j] += part[j];
    }
    for (double& value : sum) value *= 2 * pi / covered;
    return sum;
}

}  // namespace nacre
