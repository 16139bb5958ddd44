// Densities on the unit square that are bilinear between the nodes of a grid, and the maps that spread
// uniform points by them: what the measured materials of Dupuy and Jakob, "An adaptive parameterization for
// efficient material acquisition and rendering" (2018), sec. 3, are sampled with.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace nacre {

using glm::dvec2;

class SquareDensity {
  public:
    // size.y rows of size.x values >= 0, the first in (0, 0) and the last in (1, 1); at least 2 each way, and
    // no row may be 0 all along. They are scaled so that the integral is 1.
    SquareDensity(glm::ivec2 size, std::vector<double> values);

    // Where a uniform point goes: first y by the density of rows, then x within it.
    dvec2 place(dvec2 uniform) const;

    glm::ivec2 size() const { return size_; }
    const std::vector<double>& values() const { return values_; }

  private:
    friend class MixedDensity;
    double value(int x, int y) const { return values_[index(x, y)]; }
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * size_.x + x); }

    glm::ivec2 size_;
    std::vector<double> values_;
    std::vector<double> row_sums_;     // the integral of a row from 0 to each node, per unit of y
    std::vector<double> column_sums_;  // of all rows from 0 to each
};

// A weighted mean of densities of one size; the weights add up to 1.
class MixedDensity {
  public:
    struct Part {
        const SquareDensity* density;
        double weight;
    };
    explicit MixedDensity(std::span<const Part> parts) : parts_(parts) {}

    // The inverse of SquareDensity::place() of the mean. `at` lies in the square.
    dvec2 uniform(dvec2 at) const;

  private:
    // The mean of a quantity of each part.
    template <class Of>
    double mean(const Of& of) const {
        double sum = 0;
        for (const Part& part : parts_) sum += part.weight * of(*part.density);
        return sum;
    }

    std::span<const Part> parts_;
};

}  // namespace nacre
