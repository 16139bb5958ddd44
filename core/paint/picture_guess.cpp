#include "core/paint/picture_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "core/paint/normal_map.h"
#include "core/paint/pixel_normal.h"
#include "core/paint/source_raster.h"

namespace nacre {
namespace {

constexpr float clear_alpha = 0.1f;
constexpr float grey_spread = 0.04f;     // between red, green and blue
constexpr float near_an_end = 0.1f;      // of black or white
constexpr int steps = 16;                // of a channel, for the colours that are counted
constexpr std::size_t frequent = 16;     // colours
constexpr double length_off = 0.3;       // from 1: lossy formats bring normals that far
constexpr double normals_least = 0.7;    // of the pixels of a normal map
constexpr double blue_least = 0.6;       // mean z of its normals
constexpr double tilt_most = 0.2;        // of their mean
constexpr double aspect_off = 0.02;      // of an environment's two to one
constexpr int environment_width = 1024;  // pixels, at least, of one that has no light above white
constexpr double clear_least = 0.03, clear_most = 0.97;
constexpr double mostly = 0.9;
constexpr double dark_corner = 0.02, lit_disk = 0.1;  // means of a picture of the hemisphere

// What is counted while the pixels go by.
struct Counts {
    std::size_t pixels = 0, clear = 0, grey = 0, ends = 0, in_disk = 0;
    double corners = 0, disk = 0;
    std::vector<std::size_t> colours = std::vector<std::size_t>(std::size_t{steps} * steps * steps);

    std::size_t opaque() const { return pixels - clear; }

    void add(glm::vec3 c, int channels, bool inside) {
        const float mean = channels == 2 ? (c.x + c.y) / 2 : (c.x + c.y + c.z) / 3;
        const float spread = std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z});
        grey += channels == 1 || spread <= grey_spread ? 1 : 0;
        ends += mean <= near_an_end || mean >= 1 - near_an_end ? 1 : 0;
        (inside ? disk : corners) += static_cast<double>(mean);
        in_disk += inside ? 1 : 0;
        const glm::ivec3 step(glm::clamp(c * static_cast<float>(steps), 0.0f, static_cast<float>(steps - 1)));
        ++colours[static_cast<std::size_t>((step.x * steps + step.y) * steps + step.z)];
    }

    std::size_t of_frequent_colours() {
        std::partial_sort(colours.begin(), colours.begin() + frequent, colours.end(), std::greater<>());
        std::size_t sum = 0;
        for (std::size_t i = 0; i < frequent; ++i) sum += colours[i];
        return sum;
    }
};

Counts count(const ColourPicture& picture, int step) {
    Counts counts;
    const auto width = static_cast<std::size_t>(picture.width);
    visit_pixels(picture, step, [&](std::size_t i) {
        ++counts.pixels;
        if (!picture.alpha.empty() && picture.alpha[i] < clear_alpha) {
            ++counts.clear;
            return;
        }
        const glm::dvec2 at((2.0 * static_cast<double>(i % width) + 1) / picture.width - 1,
                            (2.0 * static_cast<double>(i / width) + 1) / picture.height - 1);
        counts.add(picture.colours[i], picture.channels, glm::dot(at, at) < 1);
    });
    return counts;
}

double share(std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

void measure_normals(const ColourPicture& picture, const NormalReading& reading, int step,
                     PictureStatistics& found) {
    if (picture.channels < 2) return;
    const NormalCounts counts = count_normals(picture, reading, step);
    const std::size_t filled = counts.pixels - counts.empty;
    std::size_t near = 0;
    visit_pixels(picture, step, [&](std::size_t i) {
        const dvec3 n = pixel_normal(picture, reading, i);
        near += n.z > 0 && std::abs(glm::length(n) - 1) <= length_off ? 1 : 0;
    });
    found.normals = share(near, filled);
    dvec3 mean(0);
    const std::vector<dvec3> normals = normals_of_map(picture, reading, step);
    for (const dvec3 n : normals) mean += n;
    if (!normals.empty()) mean /= static_cast<double>(normals.size());
    found.blue = mean.z;
    found.tilt = std::hypot(mean.x, mean.y);
}

}  // namespace

PictureStatistics picture_statistics(const ColourPicture& picture, const NormalReading& reading) {
    PictureStatistics found{.width = picture.width,
                            .height = picture.height,
                            .channels = picture.channels,
                            .encoded = picture.encoded};
    const int step = draft_step(picture);
    Counts counts = count(picture, step);
    const std::size_t opaque = counts.opaque();
    found.clear = share(counts.clear, counts.pixels);
    found.grey = share(counts.grey, opaque);
    found.black_or_white = share(counts.ends, opaque);
    found.few_colours = share(counts.of_frequent_colours(), opaque);
    const std::size_t in_corners = opaque - counts.in_disk;
    if (in_corners > 0) found.corners = counts.corners / static_cast<double>(in_corners);
    if (counts.in_disk > 0) found.disk = counts.disk / static_cast<double>(counts.in_disk);
    measure_normals(picture, reading, step, found);
    return found;
}

PictureGuess likely_use(const PictureStatistics& picture) {
    if (picture.channels == 2 && picture.normals >= normals_least)
        return {ImportUse::normals, "it has red and green alone"};
    if (picture.normals >= normals_least && picture.blue >= blue_least && picture.tilt <= tilt_most)
        return {ImportUse::normals, "it is mostly blue, and its normals have about length 1"};
    const double aspect = static_cast<double>(picture.width) / picture.height;
    const bool two_to_one = std::abs(aspect - 2) <= 2 * aspect_off;
    if (two_to_one && !picture.encoded)
        return {ImportUse::environment, "it is twice as wide as high, and of high dynamic range"};
    if (picture.clear >= clear_least && picture.clear <= clear_most)
        return {ImportUse::stamp, "it stands on a transparent ground"};
    const bool is_grey = picture.grey >= mostly;
    if (is_grey && picture.black_or_white >= mostly) return {ImportUse::stamp, "it is black and white alone"};
    if (is_grey && picture.width == picture.height && picture.corners <= dark_corner &&
        picture.disk >= lit_disk)
        return {ImportUse::modulation, "it is grey within a disk and black around it"};
    if (is_grey) return {ImportUse::heights, "it is grey throughout"};
    if (two_to_one && picture.width >= environment_width)
        return {ImportUse::environment, "it is twice as wide as high"};
    if (picture.few_colours >= mostly) return {ImportUse::stamp, "it has few colours"};
    return {ImportUse::stamp, "its light can be the shape of a highlight"};
}

}  // namespace nacre
