#include "core/paint/contour.h"

#include <array>
#include <cstdint>

namespace nacre {
namespace {

constexpr double level = 0.5;
constexpr std::int32_t none = -1;

// The grid with a border of zeros. A side of a cell is 2 (row * side + column), plus 1 where it goes down.
class Tracer {
  public:
    Tracer(int inner, const std::function<double(int row, int column)>& value)
        : side_(inner + 2), values_(size()), next_(2 * size(), none) {
        for (int row = 0; row < inner; ++row)
            for (int column = 0; column < inner; ++column)
                values_[index(row + 1, column + 1)] = static_cast<float>(value(row, column));
    }

    std::vector<std::vector<glm::dvec2>> lines() {
        for (int row = 0; row + 1 < side_; ++row)
            for (int column = 0; column + 1 < side_; ++column) join(row, column);
        std::vector<std::vector<glm::dvec2>> found;
        for (std::size_t first = 0; first < next_.size(); ++first) {
            if (next_[first] == none) continue;
            std::vector<glm::dvec2>& line = found.emplace_back();
            for (std::size_t edge = first; next_[edge] != none;) {
                line.push_back(crossing(edge));
                const auto after = static_cast<std::size_t>(next_[edge]);
                next_[edge] = none;
                edge = after;
            }
        }
        return found;
    }

  private:
    std::size_t size() const { return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_); }
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(column);
    }

    // Around a cell, from each side where one leaves what is inside to the next where one enters it again.
    // The cell beyond that side goes on from there.
    void join(int row, int column) {
        const std::array corners{index(row, column), index(row, column + 1), index(row + 1, column + 1),
                                 index(row + 1, column)};
        const std::array edges{2 * corners[0], 2 * corners[1] + 1, 2 * corners[3], 2 * corners[0] + 1};
        const auto inside = [&](std::size_t k) {
            return static_cast<double>(values_[corners[k % 4]]) > level;
        };
        for (std::size_t k = 0; k < 4; ++k) {
            if (!inside(k) || inside(k + 1)) continue;
            for (std::size_t m = k + 1; m < k + 4; ++m)
                if (!inside(m) && inside(m + 1)) {
                    next_[edges[k]] = static_cast<std::int32_t>(edges[m % 4]);
                    break;
                }
        }
    }

    glm::dvec2 crossing(std::size_t edge) const {
        const std::size_t a = edge / 2, b = edge % 2 == 0 ? a + 1 : a + static_cast<std::size_t>(side_);
        const auto from = static_cast<double>(values_[a]), to = static_cast<double>(values_[b]);
        const double part = (level - from) / (to - from);
        const auto side = static_cast<std::size_t>(side_);
        const glm::dvec2 corner(static_cast<double>(a % side) - 1, static_cast<double>(a / side) - 1);
        return corner + (edge % 2 == 0 ? glm::dvec2(part, 0) : glm::dvec2(0, part));
    }

    int side_;
    std::vector<float> values_;
    std::vector<std::int32_t> next_;
};

}  // namespace

std::vector<std::vector<glm::dvec2>> contours(int side,
                                              const std::function<double(int row, int column)>& value) {
    return Tracer(side, value).lines();
}

}  // namespace nacre
