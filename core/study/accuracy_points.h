// The points of a method that one chart or table shows.
#pragma once

#include <string>
#include <vector>

#include "core/study/accuracy.h"

namespace nacre {

enum class ChartOf { area, albedo };

struct ShownPoint {
    std::string setting;
    double seconds = 0;
    std::size_t bytes = 0;
    TableError error;  // of R: of both Fresnel factors together
};

std::vector<ShownPoint> shown_points(const MethodAccuracy& method, ChartOf quantity);

}  // namespace nacre
