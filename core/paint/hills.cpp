#include "core/paint/hills.h"

#include <algorithm>
#include <numeric>

#include "core/model/disk_texels.h"

namespace nacre {
namespace {

constexpr int side = hill_cells;
constexpr int blurs = 2;            // of 1 2 1 over 4, each reaching one cell
constexpr double bump_pass = 0.75;  // of its top: a bump's pass lies no lower

std::size_t cell_index(int row, int column) {
    return static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column);
}

// The mean of each cell's texels on the disk.
std::vector<double> coarse(const Raster& raster) {
    std::vector<double> sum(cell_index(side, 0)), count(sum.size());
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column) {
            if (!on_disk(raster.width, row, column)) continue;
            const std::size_t cell = cell_index(row * side / raster.height, column * side / raster.width);
            sum[cell] += static_cast<double>(
                raster.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width) +
                              static_cast<std::size_t>(column)]);
            ++count[cell];
        }
    for (std::size_t i = 0; i < sum.size(); ++i)
        if (count[i] > 0) sum[i] /= count[i];
    return sum;
}

// 1 2 1 over 4 along one axis; beyond the picture there is nothing.
std::vector<double> blurred(const std::vector<double>& before, int down, int right) {
    std::vector<double> after(before.size());
    const auto at = [&](int row, int column) {
        return row < 0 || column < 0 || row >= side || column >= side ? 0 : before[cell_index(row, column)];
    };
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            after[cell_index(row, column)] =
                (at(row - down, column - right) + 2 * at(row, column) + at(row + down, column + right)) / 4;
    return after;
}

// Cells are flooded from the highest down (Vincent and Soille 1991, watersheds by immersion from the tops):
// one without a flooded neighbour is a new top, any other joins its highest neighbour's hill. Where two hills
// meet while the lower is no more than a bump, they become one.
class Flood {
  public:
    explicit Flood(const std::vector<double>& height) : height_(height), hill_(height.size(), none) {
        std::vector<std::size_t> order(height.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::erase_if(order, [&](std::size_t cell) { return !(height[cell] > 0); });
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return height[a] > height[b]; });
        for (const std::size_t cell : order) flood(cell);
    }

    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t hill(std::size_t cell) { return hill_[cell] == none ? none : root(hill_[cell]); }

  private:
    std::size_t root(std::size_t hill) {
        while (parent_[hill] != hill) hill = parent_[hill] = parent_[parent_[hill]];
        return hill;
    }

    void flood(std::size_t cell) {
        const int row = static_cast<int>(cell / side), column = static_cast<int>(cell % side);
        std::size_t highest = none;
        std::vector<std::size_t> met;
        for (int i = std::max(row - 1, 0); i <= std::min(row + 1, side - 1); ++i)
            for (int j = std::max(column - 1, 0); j <= std::min(column + 1, side - 1); ++j) {
                const std::size_t neighbour = cell_index(i, j);
                if (hill_[neighbour] == none) continue;
                met.push_back(hill_[neighbour]);
                if (highest == none || height_[neighbour] > height_[highest]) highest = neighbour;
            }
        if (highest == none) {
            hill_[cell] = parent_.size();
            parent_.push_back(parent_.size());
            top_.push_back(height_[cell]);
            return;
        }
        hill_[cell] = hill_[highest];
        for (const std::size_t other : met) meet(other, hill_[cell], height_[cell]);
    }

    void meet(std::size_t a, std::size_t b, double pass) {
        a = root(a), b = root(b);
        if (top_[a] < top_[b]) std::swap(a, b);
        if (a != b && pass >= bump_pass * top_[b]) parent_[b] = a;
    }

    const std::vector<double>& height_;
    std::vector<std::size_t> hill_;  // of each cell, when it was flooded
    std::vector<std::size_t> parent_;
    std::vector<double> top_;
};

}  // namespace

std::optional<std::vector<float>> hill_around(const Raster& raster, int row, int column) {
    std::vector<double> height = coarse(raster);
    for (int i = 0; i < blurs; ++i) height = blurred(blurred(height, 1, 0), 0, 1);
    Flood flood(height);
    const std::size_t chosen = flood.hill(cell_index(row, column));
    if (chosen == Flood::none) return {};
    std::vector<float> membership(height.size());
    for (std::size_t cell = 0; cell < height.size(); ++cell)
        membership[cell] = flood.hill(cell) == chosen ? 1.0f : 0.0f;
    return membership;
}

}  // namespace nacre
