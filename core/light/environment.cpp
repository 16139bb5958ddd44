#include "core/light/environment.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/light/hilbert.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr int density_width = 1024;  // at most

// Mean of the three colours around a cell. The points beside it reach every texel that the picture's bilinear
// look-up mixes into the cell.
double brightness_around(const LatLong& picture, const LightDensity& grid, int column, int row) {
    const glm::dvec2 cell{1.0 / grid.width, 1.0 / grid.height};
    const glm::dvec2 texel{1.0 / picture.width, 1.0 / picture.height};
    const glm::dvec2 middle = (glm::dvec2(column, row) + 0.5) * cell, reach = 0.5 * (cell + texel);
    double sum = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const glm::dvec3 light = radiance_at(picture, middle + glm::dvec2(i, j) * reach);
            sum += (light.x + light.y + light.z) / 3 * ((2 - std::abs(i)) * (2 - std::abs(j)) / 16.0);
        }
    return sum;
}

double cell_solid_angle(const LightDensity& grid, int row) {
    return 2 * pi / grid.width * (std::cos(pi * row / grid.height) - std::cos(pi * (row + 1) / grid.height));
}

LightDensity density_of(const LatLong& picture) {
    const int coarser = (picture.width + density_width - 1) / density_width;
    LightDensity grid{picture.width / coarser, std::max(picture.height / coarser, 1), {}};
    grid.values.resize(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
    tbb::parallel_for(0, grid.height, [&](int row) {
        for (int column = 0; column < grid.width; ++column)
            grid.values[static_cast<std::size_t>(row * grid.width + column)] =
                static_cast<float>(brightness_around(picture, grid, column, row));
    });
    double sum = 0;
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column)
            sum += static_cast<double>(grid.values[static_cast<std::size_t>(row * grid.width + column)]) *
                   cell_solid_angle(grid, row);
    for (float& value : grid.values)
        value = static_cast<float>(sum > 0 ? static_cast<double>(value) / sum : 0.25 / pi);
    return grid;
}

// Cells along Hilbert's curve over the left half of the picture and then over the right one.
std::vector<glm::ivec2> cells_in_order(const LightDensity& grid) {
    const int half = (grid.width + 1) / 2;
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(half, grid.height))));
    std::vector<glm::ivec2> cells;
    for (int part = 0; part < 2; ++part)
        for (std::int64_t i = 0; i < std::int64_t{side} * side; ++i) {
            const glm::ivec2 cell = hilbert_cell(i, side) + glm::ivec2(part * half, 0);
            if (cell.x < (part == 0 ? half : grid.width) && cell.y < grid.height &&
                cell.x - part * half < half)
                cells.push_back(cell);
        }
    return cells;
}

DirectionOrder order_light(const LightDensity& grid) {
    const std::vector<glm::ivec2> order = cells_in_order(grid);
    MassCells cells;
    cells.mass.reserve(order.size());
    for (const glm::ivec2& cell : order)
        cells.mass.push_back(
            static_cast<double>(grid.values[static_cast<std::size_t>(cell.y * grid.width + cell.x)]) *
            cell_solid_angle(grid, cell.y));
    // Even in solid angle: along a meridian that is the cosine from the zenith.
    cells.direction = [&](std::size_t i, glm::dvec2 at) {
        const double top = std::cos(pi * order[i].y / grid.height);
        const double bottom = std::cos(pi * (order[i].y + 1) / grid.height);
        const double v = std::acos(std::clamp(top + (bottom - top) * at.y, -1.0, 1.0)) / pi;
        return lat_long_direction({(order[i].x + at.x) / grid.width, v});
    };
    return order_directions(cells);
}

}  // namespace

double LightDensity::at(glm::dvec2 place) const {
    const int column = std::clamp(static_cast<int>(place.x * width), 0, width - 1);
    const int row = std::clamp(static_cast<int>(place.y * height), 0, height - 1);
    return static_cast<double>(values[static_cast<std::size_t>(row * width + column)]);
}

std::shared_ptr<const Environment> make_environment(std::string name, LatLong picture) {
    auto environment = std::make_shared<Environment>();
    environment->name = std::move(name);
    environment->density = density_of(picture);
    environment->light = order_light(environment->density);
    environment->picture = std::move(picture);
    return environment;
}

}  // namespace nacre
