#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/paint/normal_map.h"
#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

constexpr double facets_max = 50;  // that one normal counts for
constexpr double reach = 3;        // of the smoothing, in standard deviations

// Bilinear, so that few normals do not leave a pattern of texels. What falls to a texel off the disk goes to
// those that it is read from.
void add_facets(std::vector<double>& sums, dvec3 n) {
    const glm::dvec2 at = disk_point(n);
    const double column = (at.x + 1) / 2 * painted_side - 0.5, row = (1 - at.y) / 2 * painted_side - 0.5;
    const double j = std::floor(column), i = std::floor(row), s = column - j, t = row - i;
    const double facets = std::min(1 / n.z, facets_max);
    const auto add = [&](double r, double c, double share) {
        const int down = std::clamp(static_cast<int>(r), 0, painted_side - 1);
        const int right = std::clamp(static_cast<int>(c), 0, painted_side - 1);
        if (on_disk(painted_side, down, right)) {
            sums[static_cast<std::size_t>(down) * painted_side + static_cast<std::size_t>(right)] +=
                share * facets;
            return;
        }
        const TexelSources sources = texel_sources(painted_side, down, right);
        for (int k = 0; k < sources.count; ++k)
            sums[sources.index[static_cast<std::size_t>(k)]] += share * facets / sources.count;
    };
    add(i, j, (1 - s) * (1 - t));
    add(i, j + 1, s * (1 - t));
    add(i + 1, j, (1 - s) * t);
    add(i + 1, j + 1, s * t);
}

std::vector<double> gaussian_weights(double deviation) {
    const int half = static_cast<int>(std::ceil(reach * deviation));
    std::vector<double> weights;
    for (int i = -half; i <= half; ++i) weights.push_back(std::exp(-0.5 * i * i / (deviation * deviation)));
    return weights;
}

// Along rows and turned, so that twice is both ways.
std::vector<double> smoothed_and_turned(const std::vector<double>& sums, const std::vector<double>& weights) {
    const int half = static_cast<int>(weights.size()) / 2;
    std::vector<double> result(sums.size());
    for (int row = 0; row < painted_side; ++row)
        for (int column = 0; column < painted_side; ++column) {
            double sum = 0;
            for (int k = std::max(-half, -column); k <= std::min(half, painted_side - 1 - column); ++k)
                sum += weights[static_cast<std::size_t>(k + half)] *
                       sums[static_cast<std::size_t>(row * painted_side + column + k)];
            result[static_cast<std::size_t>(column * painted_side + row)] = sum;
        }
    return result;
}

}  // namespace

std::shared_ptr<const Raster> raster_of_normals(const std::vector<dvec3>& normals, double width) {
    std::vector<double> sums(std::size_t{painted_side} * painted_side);
    for (const dvec3 n : normals)
        if (n.z > 0) add_facets(sums, n);
    // Near n a radian is 1/sqrt(2) of the disk's radius, which is half the side.
    const double deviation = width * (std::numbers::pi / 180) / std::numbers::sqrt2 * painted_side / 2;
    if (deviation > 0.1) {
        const std::vector<double> weights = gaussian_weights(deviation);
        sums = smoothed_and_turned(smoothed_and_turned(sums, weights), weights);
    }
    const double largest = *std::max_element(sums.begin(), sums.end());
    if (!(largest > 0)) throw UserError("", "normals", "a normal at least must face up");
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = painted_side;
    for (const double sum : sums) raster->values.push_back(static_cast<float>(sum / largest));
    return raster;
}

}  // namespace nacre
