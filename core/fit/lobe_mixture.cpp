#include "core/fit/lobe_mixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/fit/view_mask.h"
#include "core/model/polar_angles.h"

namespace nacre {

namespace {

constexpr double degree = std::numbers::pi / 180;

double read_tile(const std::vector<float>& tile, dvec3 v) {
    const dvec2 at = texel_place(v, tile_side);
    const int column = std::min(static_cast<int>(at.x), tile_side - 2);
    const int row = std::min(static_cast<int>(at.y), tile_side - 2);
    const float* corner = &tile[static_cast<std::size_t>(row * tile_side + column)];
    const auto along = [x = at.x - column](const float* pair) {
        return static_cast<double>(pair[0]) * (1 - x) + static_cast<double>(pair[1]) * x;
    };
    const double y = at.y - row;
    return along(corner) * (1 - y) + along(corner + tile_side) * y;
}

}  // namespace

LobeFrame frame_of(const MixtureLobe& lobe) {
    LobeFrame frame;
    frame.weight = lobe.weight;
    turn_frame(frame, polar_direction(lobe.tilt, lobe.azimuth));
    const double c = std::cos(lobe.rotation * degree), s = std::sin(lobe.rotation * degree);
    const double wide = 1 / (lobe.alpha_x * lobe.alpha_x), narrow = 1 / (lobe.alpha_y * lobe.alpha_y);
    frame.a11 = c * c * wide + s * s * narrow;
    frame.a22 = s * s * wide + c * c * narrow;
    frame.a12 = c * s * (wide - narrow);
    return frame;
}

MixtureLobe lobe_of(const LobeFrame& frame) {
    const double middle = 0.5 * (frame.a11 + frame.a22), half = 0.5 * (frame.a11 - frame.a22);
    const double reach = std::hypot(half, frame.a12);
    MixtureLobe lobe;
    lobe.weight = frame.weight;
    lobe.alpha_x = 1 / std::sqrt(middle - reach);
    lobe.alpha_y = 1 / std::sqrt(middle + reach);
    // The narrow axis has the larger precision.
    const double narrow = reach > 1e-12 * middle ? 0.5 * std::atan2(frame.a12, half) / degree : -90;
    lobe.rotation = narrow < 0 ? narrow + 90 : narrow - 90;
    if (lobe.rotation < 0) lobe.rotation += 180;
    lobe.tilt = polar_angle(frame.N);
    lobe.azimuth = nacre::azimuth(frame.N);
    return lobe;
}

MixtureReader::MixtureReader(const LobeMixture& mixture) : mixture_(mixture) {
    for (const MixtureLobe& lobe : mixture.lobes) frames_.push_back(frame_of(lobe));
}

double MixtureReader::operator()(dvec3 v, dvec3 l) const {
    if (v.z <= 0 || l.z <= 0) return 0;
    const dvec3 h = glm::normalize(v + l);
    double sum = 0;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        LobeTerms terms;
        if (!lobe_terms(mixture_.shape, frames_[i], v, l, h, terms)) continue;
        const bool constant = mixture_.weights == LobeWeights::constant;
        const double weight = constant ? frames_[i].weight : read_tile(mixture_.lobes[i].tile, v);
        sum += weight * terms.bare / terms.v.z;
    }
    return sum;
}

double LobeMixture::brdf(dvec3 v, dvec3 l) const { return MixtureReader(*this)(v, l); }

}  // namespace nacre
