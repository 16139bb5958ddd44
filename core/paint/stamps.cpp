#include "core/paint/stamps.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <utility>

#include "core/image/area_average.h"
#include "core/model/facet_distribution.h"
#include "core/paint/brush.h"
#include "core/paint/raster_texels.h"

namespace nacre {
namespace {

using glm::dvec2;

constexpr int side = 256;
constexpr double edge = 0.02;  // half the width of a shape's soft edge; the picture reaches from -1 to 1

double soft(double distance) { return std::clamp(0.5 - distance / (2 * edge), 0.0, 1.0); }

double disc(dvec2 at, dvec2 middle, double radius) { return soft(glm::length(at - middle) - radius); }

double arc(dvec2 at, double radius, double width, double low, double high) {
    if (std::abs(glm::length(at) - radius) > width / 2 + edge) return 0;
    const double angle = std::atan2(at.y, at.x);
    const double inside = std::clamp(angle, low, high);
    const dvec2 nearest = radius * dvec2(std::cos(inside), std::sin(inside));
    return soft(glm::length(at - nearest) - width / 2);
}

double smiley(dvec2 at) {
    const double outline = soft(std::abs(glm::length(at) - 0.86) - 0.055);
    const double eyes = std::max(disc(at, {-0.32, 0.28}, 0.12), disc(at, {0.32, 0.28}, 0.12));
    const double mouth = arc(at, 0.5, 0.11, -0.86 * std::numbers::pi, -0.14 * std::numbers::pi);
    return std::max({outline, eyes, mouth});
}

// A square on its corner with half a disc on each of its upper sides.
double heart(dvec2 at) {
    constexpr double corner = 0.78, middle = -0.08;  // from the square's middle, and where that is
    const dvec2 p(std::abs(at.x), at.y - middle);
    const double square = (p.x + std::abs(p.y) - corner) / std::numbers::sqrt2;
    const double round = glm::length(p - dvec2(corner / 2)) - corner / std::numbers::sqrt2;
    return soft(std::min(square, round));
}

double star(dvec2 at) {
    static const dvec2 half(std::cos(std::numbers::pi / 5), std::sin(std::numbers::pi / 5));
    // Mirrored into the tenth between the upper tip and the notch at its right.
    dvec2 p(std::abs(at.x), at.y);
    for (const dvec2 mirror : {dvec2(half.x, -half.y), -half})
        p -= 2 * std::max(glm::dot(mirror, p), 0.0) * mirror;
    // The line from a tip to the notch beside it.
    const dvec2 tip(0.92, 0), notch = 0.36 * half, line = notch - tip;
    p = dvec2(p.y, std::abs(p.x)) - tip;
    return soft((line.x * p.y - line.y * p.x) / -glm::length(line));
}

double grid(dvec2 at) {
    if (std::max(std::abs(at.x), std::abs(at.y)) >= 0.98) return 0;
    constexpr double step = 0.4;
    return disc(at - step * glm::round(at / step), {0, 0}, 0.11);
}

template <class Value>
std::shared_ptr<const Raster> drawn(const Value& value) {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = side;
    raster->values.reserve(std::size_t{side} * side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            raster->values.push_back(static_cast<float>(value(texel_point(side, row, column))));
    return raster;
}

}  // namespace

NamedStamp named_stamp(std::string name, std::shared_ptr<const Raster> picture) {
    auto thumbnail = picture;
    if (picture->width > thumbnail_side)
        thumbnail = std::make_shared<const Raster>(area_average(*picture, thumbnail_side));
    return {std::move(name), std::move(picture), std::move(thumbnail)};
}

glm::dmat2 stamp_from_layer(const Layer& layer, dvec3 at, const StampPose& pose) {
    constexpr double opposite = -1 + 1e-9;  // there every rotation to the pole is as short
    const glm::dmat3 to_surface = layer_frame(layer);
    const dvec3 seen = to_surface * at, pole(0, 0, 1);
    glm::dmat3 plane(1);
    if (at.z > opposite && seen.z > opposite)
        plane = glm::transpose(shortest_rotation(pole, seen)) * to_surface * shortest_rotation(pole, at);
    const double angle = pose.angle * (std::numbers::pi / 180), c = std::cos(angle), s = std::sin(angle);
    const glm::dmat2 turned_back{{c, -s}, {s, c}};
    const glm::dmat2 flipped{{pose.flip ? -1 : 1, 0}, {0, 1}};
    return flipped * turned_back * -glm::dmat2(plane);
}

std::vector<NamedStamp> built_in_stamps() {
    return {named_stamp("Smiley", drawn(smiley)), named_stamp("Heart", drawn(heart)),
            named_stamp("Star", drawn(star)), named_stamp("Dots", drawn(grid))};
}

}  // namespace nacre
