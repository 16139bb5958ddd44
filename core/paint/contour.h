// The line around what is selected.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

namespace nacre {

// Closed lines where a field on a square grid crosses 1/2, in units of the grid's steps. What lies beyond the
// grid counts as 0.
std::vector<std::vector<glm::dvec2>> contours(int side,
                                              const std::function<double(int row, int column)>& value);

}  // namespace nacre
