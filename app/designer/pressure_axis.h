// A pen's pressure among the numbers that a device tells.
#pragma once

#include <optional>
#include <span>

namespace nacre {

// One of a device's axes, which X calls valuators, and its range in the device's own units.
struct PressureAxis {
    int number;
    double low, high;
};

// The pressure, 0 to 1, of an event that holds the values of those axes alone whose bit in `mask` is set, in
// their order (XIValuatorState). Nothing where that of the axis is not among them or is no number.
std::optional<double> pressure_of(const PressureAxis& axis, std::span<const unsigned char> mask,
                                  const double* values);

}  // namespace nacre
