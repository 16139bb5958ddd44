#include "core/pictures/light_of.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

constexpr double table_last = 65535;

double decode(double value, double gamma) {
    if (gamma > 0) return std::pow(value, gamma);
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

LightOf::LightOf(const PictureHeader& header) : header_(header) {
    if (!header.encoded || header.bits > 16) return;
    table_.reserve(static_cast<std::size_t>(table_last) + 1);
    for (int i = 0; i <= static_cast<int>(table_last); ++i)
        table_.push_back(decode(i / table_last, header.gamma));
}

double LightOf::decoded(double value) const {
    if (table_.empty()) return decode(std::clamp(value, 0.0, 1.0), header_.gamma);
    return table_[static_cast<std::size_t>(std::clamp(value, 0.0, 1.0) * table_last + 0.5)];
}

glm::dvec3 LightOf::operator()(const glm::vec4& pixel) const {
    const double alpha = header_.has_alpha ? static_cast<double>(pixel.w) : 1;
    glm::dvec3 light(pixel);
    if (header_.encoded && header_.associated) {
        // The product was encoded as it stands: first the colour alone.
        if (alpha <= 0) return glm::dvec3(0);
        for (int c = 0; c < 3; ++c) light[c] = decode(std::min(light[c] / alpha, 1.0), header_.gamma) * alpha;
    } else {
        if (header_.encoded) light = {decoded(light.x), decoded(light.y), decoded(light.z)};
        if (!header_.associated) light *= alpha;
    }
    return header_.to_rec709 ? *header_.to_rec709 * light : light;
}

}  // namespace nacre
