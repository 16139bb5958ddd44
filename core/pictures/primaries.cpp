#include "core/pictures/primaries.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace nacre {
namespace {

constexpr std::array<double, 8> rec709{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};

glm::dvec3 xyz(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

// RGB to XYZ over the XYZ of white, so that two such matrices have the same white (von Kries in XYZ).
glm::dmat3 to_xyz(const std::array<double, 8>& xy) {
    const glm::dmat3 primaries(xyz(xy[0], xy[1]), xyz(xy[2], xy[3]), xyz(xy[4], xy[5]));
    const glm::dvec3 white = xyz(xy[6], xy[7]);
    const glm::dvec3 amounts = glm::inverse(primaries) * white;
    glm::dmat3 result;
    for (int c = 0; c < 3; ++c) result[c] = primaries[c] * amounts[c] / white;
    return result;
}

}  // namespace

std::optional<glm::dmat3> to_rec709(const std::array<double, 8>& xy) {
    double difference = 0;
    for (std::size_t i = 0; i < xy.size(); ++i)
        difference = std::max(difference, std::abs(xy[i] - rec709[i]));
    if (difference < 0.002) return {};
    const glm::dmat3 matrix = glm::inverse(to_xyz(rec709)) * to_xyz(xy);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(matrix[c][r]) < 100)) return {};
    return matrix;
}

}  // namespace nacre
