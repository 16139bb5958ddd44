#include "core/image/area_average.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace nacre {
namespace {

// Rows of `from` values become columns of `to` values: used twice, it shrinks both axes and leaves
// the picture as it stood.
std::vector<double> shrink_and_transpose(const std::vector<double>& values, std::size_t from,
                                         std::size_t to) {
    const std::size_t rows = values.size() / from;
    const double step = static_cast<double>(from) / static_cast<double>(to);
    std::vector<double> result(rows * to);
    for (std::size_t i = 0; i < to; ++i) {
        const double start = static_cast<double>(i) * step;
        const double end = std::min(start + step, static_cast<double>(from));
        const auto first = static_cast<std::size_t>(start);
        const auto last = std::min(static_cast<std::size_t>(std::ceil(end)), from);
        for (std::size_t row = 0; row < rows; ++row) {
            double sum = 0;
            for (std::size_t j = first; j < last; ++j) {
                const auto left = static_cast<double>(j);
                sum += values[row * from + j] * (std::min(end, left + 1) - std::max(start, left));
            }
            result[i * rows + row] = sum / (end - start);
        }
    }
    return result;
}

}  // namespace

Raster area_average(const Raster& raster, int side) {
    assert(raster.width == raster.height && side >= 1 && side <= raster.width);
    const auto from = static_cast<std::size_t>(raster.width);
    const auto to = static_cast<std::size_t>(side);
    const std::vector<double> whole(raster.values.begin(), raster.values.end());
    const std::vector<double> means = shrink_and_transpose(shrink_and_transpose(whole, from, to), from, to);
    Raster smaller{side, side, std::vector<float>(to * to)};
    std::transform(means.begin(), means.end(), smaller.values.begin(),
                   [](double mean) { return static_cast<float>(mean); });
    return smaller;
}

}  // namespace nacre
