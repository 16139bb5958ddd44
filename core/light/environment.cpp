#include "core/light/environment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/light/hilbert.h"

namespace nacre {
namespace {

using std::numbers::pi;

// The patch between four texel centres, on which the picture is bilinear; beyond the first and the last row
// of centres half a texel high.
struct Patch {
    double top, bottom;   // v
    double corner[2][2];  // brightness: [row][column]
    double solid_angle;

    double mass() const {
        return (corner[0][0] + corner[0][1] + corner[1][0] + corner[1][1]) / 4 * solid_angle;
    }
};

Patch patch_at(const LatLong& picture, glm::ivec2 cell) {
    const auto brightness = [&](int column, int row) {
        const std::size_t at = static_cast<std::size_t>(std::clamp(row, 0, picture.height - 1)) *
                                   static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>((column + picture.width) % picture.width);
        const glm::dvec3 light(picture.radiance[at]);
        return (light.x + light.y + light.z) / 3;
    };
    Patch patch{std::max(cell.y - 0.5, 0.0) / picture.height,
                std::min(cell.y + 0.5, static_cast<double>(picture.height)) / picture.height,
                {},
                0};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            patch.corner[row][column] = brightness(cell.x - 1 + column, cell.y - 1 + row);
    patch.solid_angle = 2 * pi / picture.width * (std::cos(pi * patch.top) - std::cos(pi * patch.bottom));
    return patch;
}

// Where in [0, 1] a density that is linear from `a` to `b` has the part `part` of its mass below.
double linear_quantile(double a, double b, double part) {
    const double root = std::sqrt(a * a + (b * b - a * a) * part);
    return a + root > 0 ? part * (a + b) / (a + root) : part;
}

// Patches along Hilbert's curve over the left half of the picture and then over the right one.
std::vector<glm::ivec2> patches_in_order(const LatLong& picture) {
    const int half = (picture.width + 1) / 2, rows = picture.height + 1;
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(half, rows))));
    std::vector<glm::ivec2> cells;
    cells.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(rows));
    for (int left = 0; left < picture.width; left += half)
        for (std::int64_t i = 0; i < std::int64_t{side} * side; ++i) {
            const glm::ivec2 cell = hilbert_cell(i, side);
            if (cell.x < half && left + cell.x < picture.width && cell.y < rows)
                cells.emplace_back(left + cell.x, cell.y);
        }
    return cells;
}

}  // namespace

std::shared_ptr<const Environment> make_environment(std::string name, LatLong picture,
                                                    std::vector<std::string> notes) {
    auto environment = std::make_shared<Environment>();
    const std::vector<glm::ivec2> order = patches_in_order(picture);
    MassCells cells;
    cells.mass.reserve(order.size());
    for (const glm::ivec2& cell : order) {
        cells.mass.push_back(patch_at(picture, cell).mass());
        environment->brightness += cells.mass.back();
    }
    if (!(environment->brightness > 0))
        for (std::size_t i = 0; i < order.size(); ++i)
            cells.mass[i] = patch_at(picture, order[i]).solid_angle;
    cells.direction = [&](std::size_t i, glm::dvec2 at) {
        const Patch patch = patch_at(picture, order[i]);
        const auto& c = patch.corner;
        const double y = linear_quantile(c[0][0] + c[0][1], c[1][0] + c[1][1], at.y);
        const double x =
            linear_quantile(c[0][0] * (1 - y) + c[1][0] * y, c[0][1] * (1 - y) + c[1][1] * y, at.x);
        return lat_long_direction(
            {(order[i].x - 0.5 + x) / picture.width, patch.top + (patch.bottom - patch.top) * y});
    };
    environment->light = order_directions(cells);
    environment->name = std::move(name);
    environment->picture = std::move(picture);
    environment->notes = std::move(notes);
    return environment;
}

}  // namespace nacre
