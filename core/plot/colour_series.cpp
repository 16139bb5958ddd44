#include "core/plot/colour_series.h"

#include <algorithm>
#include <cmath>

namespace nacre {

bool is_grey(const dvec3& colour) {
    const double most = std::max({std::fabs(colour.x), std::fabs(colour.y), std::fabs(colour.z)});
    return std::fabs(colour.x - colour.y) <= 1e-9 * most && std::fabs(colour.y - colour.z) <= 1e-9 * most;
}

std::vector<Series> colour_series(const std::string& name, bool grey) {
    if (grey) return {{.name = name}};
    return {{.name = name + " red", .ink = Ink::red},
            {.name = name + " green", .ink = Ink::green},
            {.name = name + " blue", .ink = Ink::blue}};
}

}  // namespace nacre
