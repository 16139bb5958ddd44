#include "app/designer/pressure_axis.h"

#include <algorithm>
#include <cmath>

namespace nacre {

std::optional<double> pressure_of(const PressureAxis& axis, std::span<const unsigned char> mask,
                                  const double* values) {
    const auto holds = [&](int number) {
        const auto byte = static_cast<std::size_t>(number) / 8;
        return byte < mask.size() && (mask[byte] >> (number % 8) & 1) != 0;
    };
    if (axis.number < 0 || !holds(axis.number) || !(axis.high > axis.low)) return {};
    int before = 0;
    for (int number = 0; number < axis.number; ++number) before += holds(number) ? 1 : 0;
    const double pressure = (values[before] - axis.low) / (axis.high - axis.low);
    if (!std::isfinite(pressure)) return {};
    return std::clamp(pressure, 0.0, 1.0);
}

}  // namespace nacre
