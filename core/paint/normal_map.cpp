#include "core/paint/normal_map.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/paint/pixel_normal.h"

namespace nacre {
namespace {

constexpr double same_blue = 0.01;          // spread of a blue that is the same everywhere
constexpr double right_length = 0.01;       // mean deviation from 1 of lengths that are meant as 1
constexpr double resized_by = 0.05;         // deviation of a length that is reported
constexpr double no_direction = 0.1;        // length of what is no normal
constexpr double plain_negative = 0.02;     // below 0 by more than ringing filters leave
constexpr std::size_t rows_of = 1'000'000;  // pixels whose curl is looked at
constexpr double plainly = 1.5;             // factor between curls of which the smaller is believed

dvec3 components(glm::vec3 colour, const NormalReading& reading) {
    dvec3 n = reading.is_signed ? dvec3(colour) : 2.0 * dvec3(colour) - 1.0;
    if (reading.two_channels) n.z = std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y));
    if (reading.green_down) n.y = -n.y;
    return n;
}

// Black is a normal only where 0 stands for x and y that are 0.
bool is_empty(const ColourPicture& picture, const NormalReading& reading, std::size_t i) {
    if (!picture.alpha.empty() && picture.alpha[i] == 0) return true;
    return picture.colours[i] == glm::vec3(0) && !(reading.is_signed && reading.two_channels);
}

enum class Kind { normal, empty, not_facing_up };

Kind kind_of(const ColourPicture& picture, const NormalReading& reading, std::size_t i, dvec3 n) {
    if (is_empty(picture, reading, i) || glm::length(n) < no_direction) return Kind::empty;
    return n.z > 0 ? Kind::normal : Kind::not_facing_up;
}

// Mean deviation of the lengths from 1, each counted as 1 at most, so that no few decide.
double length_error(const ColourPicture& picture, const NormalReading& reading) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < picture.colours.size(); ++i) {
        if (is_empty(picture, reading, i)) continue;
        sum += std::min(1.0, std::abs(glm::length(components(picture.colours[i], reading)) - 1));
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

// Of two channels the length says little: whether a share of them is plainly negative, or their mean lies
// nearer to 0 than to a half.
bool two_channels_are_signed(const ColourPicture& picture) {
    double sum = 0, negative = 0;
    for (const glm::vec3& colour : picture.colours) {
        sum += static_cast<double>(colour.x + colour.y) / 2;
        if (std::min(colour.x, colour.y) < -static_cast<float>(plain_negative)) ++negative;
    }
    const auto count = static_cast<double>(picture.colours.size());
    return negative > 0.01 * count || std::abs(sum / count) < std::abs(sum / count - 0.5);
}

bool blue_is_the_same_everywhere(const ColourPicture& picture) {
    const auto [low, high] =
        std::minmax_element(picture.colours.begin(), picture.colours.end(),
                            [](const glm::vec3& a, const glm::vec3& b) { return a.z < b.z; });
    return static_cast<double>(high->z - low->z) <= same_blue;
}

// A blue that is the same everywhere may be the z of normals that are all tilted alike.
bool blue_is_z(const ColourPicture& picture, const NormalReading& reading) {
    return components(picture.colours[0], reading).z > 0 && length_error(picture, reading) <= right_length;
}

NormalReading reading_of(const ColourPicture& picture) {
    const NormalReading from_half{false, false, false}, as_is{true, false, false};
    const bool may_be_signed = !picture.encoded;
    const bool nearer_as_is =
        may_be_signed && length_error(picture, as_is) < length_error(picture, from_half);
    const NormalReading of_three = nearer_as_is ? as_is : from_half;
    const bool two =
        picture.channels == 2 ||
        (picture.channels == 3 && blue_is_the_same_everywhere(picture) && !blue_is_z(picture, of_three));
    if (!two) return of_three;
    return {may_be_signed && two_channels_are_signed(picture), true, false};
}

// -x/z and -y/z; none where the pixel is left out.
std::optional<glm::dvec2> slope_at(const ColourPicture& picture, const NormalReading& reading, int row,
                                   int column) {
    const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                   static_cast<std::size_t>(column);
    const dvec3 n = components(picture.colours[i], reading);
    // Steep ones would outweigh all others, and are told the worst.
    if (is_empty(picture, reading, i) || !(n.z > 0.2)) return {};
    return glm::dvec2(-n.x, -n.y) / n.z;
}

std::optional<bool> green_by_curl(const ColourPicture& picture, const NormalReading& reading) {
    double up = 0, down = 0;
    // Of a large picture some rows are enough.
    const int step = 1 + static_cast<int>(picture.colours.size() / rows_of);
    for (int row = 1; row + 1 < picture.height; row += step)
        for (int column = 1; column + 1 < picture.width; ++column) {
            const auto left = slope_at(picture, reading, row, column - 1);
            const auto right = slope_at(picture, reading, row, column + 1);
            const auto above = slope_at(picture, reading, row - 1, column);
            const auto below = slope_at(picture, reading, row + 1, column);
            if (!left || !right || !above || !below) continue;
            const double x_along_y = above->x - below->x, y_along_x = right->y - left->y;
            up += (x_along_y - y_along_x) * (x_along_y - y_along_x);
            down += (x_along_y + y_along_x) * (x_along_y + y_along_x);
        }
    if (up > plainly * down) return true;
    if (down > plainly * up) return false;
    return {};
}

}  // namespace

dvec3 pixel_normal(const ColourPicture& picture, const NormalReading& reading, std::size_t pixel) {
    return components(picture.colours[pixel], reading);
}

NormalMapLook look_at_normal_map(const ColourPicture& picture) {
    NormalMapLook look{reading_of(picture), {}};
    if (picture.channels > 1) look.green_down = green_by_curl(picture, look.reading);
    return look;
}

std::vector<dvec3> normals_of_map(const ColourPicture& picture, const NormalReading& reading, int step) {
    if (picture.channels < 2)
        throw UserError("", "normals", "a map of normals must have red and green", "grey alone");
    std::vector<dvec3> normals;
    visit_pixels(picture, step, [&](std::size_t i) {
        const dvec3 n = components(picture.colours[i], reading);
        if (kind_of(picture, reading, i, n) == Kind::normal) normals.push_back(glm::normalize(n));
    });
    return normals;
}

NormalCounts count_normals(const ColourPicture& picture, const NormalReading& reading, int step) {
    NormalCounts counts;
    visit_pixels(picture, step, [&](std::size_t i) {
        ++counts.pixels;
        const dvec3 n = components(picture.colours[i], reading);
        switch (kind_of(picture, reading, i, n)) {
            case Kind::empty:
                ++counts.empty;
                break;
            case Kind::not_facing_up:
                ++counts.not_facing_up;
                break;
            case Kind::normal:
                if (std::abs(glm::length(n) - 1) > resized_by) ++counts.resized;
        }
    });
    return counts;
}

std::string note_on(const NormalCounts& counts) {
    std::string text;
    const auto tell = [&](std::size_t count, const char* what) {
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    };
    tell(counts.empty, "empty and left out");
    tell(counts.not_facing_up, "not facing up and left out");
    tell(counts.resized, "brought to length 1");
    return text.empty() ? text : fmt::format("of {} pixels {}", counts.pixels, text);
}

std::vector<dvec3> normals_of_heights(const ColourPicture& picture, double depth, int step) {
    const auto height = [&](int row, int column) {
        const int i = (row + picture.height) % picture.height, j = (column + picture.width) % picture.width;
        const glm::vec3 c = picture.colours[static_cast<std::size_t>(i * picture.width + j)];
        const float mean = picture.channels == 2 ? (c.x + c.y) / 2 : (c.x + c.y + c.z) / 3;
        return static_cast<double>(mean) * depth * picture.width;
    };
    std::vector<dvec3> normals;
    for (int i = 0; i < picture.height; i += step)
        for (int j = 0; j < picture.width; j += step) {
            const double along_x = (height(i, j + 1) - height(i, j - 1)) / 2;
            const double along_y = (height(i - 1, j) - height(i + 1, j)) / 2;
            normals.push_back(glm::normalize(dvec3(-along_x, -along_y, 1)));
        }
    return normals;
}

}  // namespace nacre
