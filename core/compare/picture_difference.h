// How far two pictures of the same scene are apart.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace nacre {

// Linear radiance, over all colours of the pixels that count.
struct DifferenceNumbers {
    double root_mean_square = 0;
    double largest = 0;
    double relative = 0;  // root mean square over that of both pictures together; 0 where both are black
    std::size_t pixels = 0;
};

// Both hold `channels` floats a pixel, of which the first three count. `counts` says which pixels do.
DifferenceNumbers measure_difference(std::span<const float> a, std::span<const float> b, int channels,
                                     const std::function<bool(std::size_t pixel)>& counts);

struct DifferenceLook {
    double amplification = 4;
    bool is_signed = false;
    bool operator==(const DifferenceLook&) const = default;
};

// sRGB in [0, 1], three floats a pixel: |b - a| of each colour; or, signed, the luminance of b - a, orange
// where b is brighter and blue where a is. Black where they are equal, at its brightest at 1/amplification.
std::vector<float> difference_picture(std::span<const float> a, std::span<const float> b, int channels,
                                      const DifferenceLook& look);

// Columns of `a` up to `divider` (part of the width), then those of `b`; `channels` floats a pixel.
std::vector<float> divided_picture(std::span<const float> a, std::span<const float> b, glm::ivec2 size,
                                   int channels, double divider);

// The first column that `divided_picture` takes from b.
int divider_column(int columns, double divider);

}  // namespace nacre
