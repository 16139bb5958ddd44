#include "core/compare/picture_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/image/luminance.h"
#include "core/image/srgb.h"

namespace nacre {
namespace {

using glm::dvec3;

constexpr dvec3 brighter{1, 0.55, 0.14}, darker{0.2, 0.56, 1};

dvec3 colour_at(std::span<const float> picture, std::size_t pixel, std::size_t channels) {
    const float* const c = &picture[pixel * channels];
    return {c[0], c[1], c[2]};
}

}  // namespace

DifferenceNumbers measure_difference(std::span<const float> a, std::span<const float> b, int channels,
                                     const std::function<bool(std::size_t pixel)>& counts) {
    assert(a.size() == b.size());
    const auto stride = static_cast<std::size_t>(channels);
    DifferenceNumbers numbers;
    double squares = 0, of_both = 0;
    for (std::size_t pixel = 0; pixel < a.size() / stride; ++pixel) {
        if (!counts(pixel)) continue;
        const dvec3 left = colour_at(a, pixel, stride), right = colour_at(b, pixel, stride);
        const dvec3 apart = glm::abs(right - left);
        numbers.largest = std::max({numbers.largest, apart.x, apart.y, apart.z});
        squares += glm::dot(apart, apart);
        of_both += 0.5 * (glm::dot(left, left) + glm::dot(right, right));
        ++numbers.pixels;
    }
    if (numbers.pixels > 0)
        numbers.root_mean_square = std::sqrt(squares / (3 * static_cast<double>(numbers.pixels)));
    if (of_both > 0) numbers.relative = std::sqrt(squares / of_both);
    return numbers;
}

std::vector<float> difference_picture(std::span<const float> a, std::span<const float> b, int channels,
                                      const DifferenceLook& look) {
    assert(a.size() == b.size());
    const auto stride = static_cast<std::size_t>(channels);
    std::vector<float> picture;
    picture.reserve(a.size() / stride * 3);
    for (std::size_t pixel = 0; pixel < a.size() / stride; ++pixel) {
        const dvec3 apart = look.amplification * (colour_at(b, pixel, stride) - colour_at(a, pixel, stride));
        dvec3 colour = glm::abs(apart);
        if (look.is_signed) {
            const double y = luminance(apart);
            colour = std::fmin(std::fabs(y), 1) * (y > 0 ? brighter : darker);
        }
        for (int c = 0; c < 3; ++c)
            picture.push_back(static_cast<float>(srgb_encoded(std::fmin(colour[c], 1))));
    }
    return picture;
}

int divider_column(int columns, double divider) {
    return std::clamp(static_cast<int>(std::lround(divider * columns)), 0, columns);
}

std::vector<float> divided_picture(std::span<const float> a, std::span<const float> b, glm::ivec2 size,
                                   int channels, double divider) {
    assert(a.size() == b.size());
    const auto row = static_cast<std::size_t>(size.x * channels);
    const auto left = static_cast<std::size_t>(divider_column(size.x, divider) * channels);
    std::vector<float> picture(b.begin(), b.end());
    for (std::size_t at = 0; at < a.size(); at += row)
        std::copy_n(a.begin() + static_cast<std::ptrdiff_t>(at), left,
                    picture.begin() + static_cast<std::ptrdiff_t>(at));
    return picture;
}

}  // namespace nacre
