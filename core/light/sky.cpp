#include "core/light/sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double sun_outside = 128;                     // klx, before the atmosphere
constexpr glm::dvec3 wavelengths{0.610, 0.550, 0.465};  // micrometres, for red, green and blue
constexpr double lowest_cosine = 0.01;                  // Perez's formula has a pole at the horizon

// A chromaticity with its luminance as linear Rec. 709.
glm::dvec3 rgb_of(double x, double y, double luminance) {
    const double big_x = x / y * luminance, big_z = (1 - x - y) / y * luminance;
    return glm::max(glm::dvec3{3.2404542 * big_x - 1.5371385 * luminance - 0.4985314 * big_z,
                               -0.9692660 * big_x + 1.8760108 * luminance + 0.0415560 * big_z,
                               0.0556434 * big_x - 0.2040259 * luminance + 1.0572252 * big_z},
                    glm::dvec3{0});
}

// A cubic in the sun's angle whose coefficients are quadratics in the turbidity; rows of T^2, T and 1.
double zenith_colour(const double (&rows)[3][4], double turbidity, double theta) {
    double sum = 0;
    for (const auto& row : rows)
        sum = sum * turbidity + ((row[0] * theta + row[1]) * theta + row[2]) * theta + row[3];
    return sum;
}

constexpr double zenith_x[3][4] = {{0.00166, -0.00375, 0.00209, 0},
                                   {-0.02903, 0.06377, -0.03202, 0.00394},
                                   {0.11693, -0.21196, 0.06052, 0.25886}};
constexpr double zenith_y[3][4] = {{0.00275, -0.00610, 0.00317, 0},
                                   {-0.04214, 0.08970, -0.04153, 0.00516},
                                   {0.15346, -0.26756, 0.06670, 0.26688}};

}  // namespace

double ClearSky::Perez::at(double cosine, double angle_to_sun) const {
    const double towards = std::cos(angle_to_sun);
    return (1 + a * std::exp(b / cosine)) * (1 + c * std::exp(d * angle_to_sun) + e * towards * towards);
}

ClearSky::ClearSky(glm::dvec3 sun, double turbidity)
    : sun_(sun), turbidity_(turbidity), theta_(std::acos(sun.y)) {
    const double t = turbidity;
    luminance_ = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                  -0.0670 * t + 0.3703};
    x_ = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
          -0.0033 * t + 0.0452};
    y_ = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
          -0.0109 * t + 0.0529};
    const double chi = (4.0 / 9 - t / 120) * (pi - 2 * theta_);
    const double luminance = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
    zenith_ = {zenith_colour(zenith_x, t, theta_) / x_.at(1, theta_),
               zenith_colour(zenith_y, t, theta_) / y_.at(1, theta_), luminance / luminance_.at(1, theta_)};
}

glm::dvec3 ClearSky::radiance(glm::dvec3 direction) const {
    const double cosine = std::max(direction.y, lowest_cosine);
    const double angle = std::acos(std::clamp(glm::dot(direction, sun_), -1.0, 1.0));
    return rgb_of(zenith_.x * x_.at(cosine, angle), zenith_.y * y_.at(cosine, angle),
                  zenith_.z * luminance_.at(cosine, angle));
}

// Beer's law with the air mass of Kasten (1966): Rayleigh's scattering, and Angstrom's turbidity for haze.
glm::dvec3 ClearSky::sun_illuminance() const {
    const double mass = 1 / (sun_.y + 0.15 * std::pow(93.885 - theta_ * 180 / pi, -1.253));
    const double haze = 0.04608 * turbidity_ - 0.04586;
    glm::dvec3 through;
    for (int i = 0; i < 3; ++i)
        through[i] = std::exp(
            -mass * (0.008735 * std::pow(wavelengths[i], -4.08) + haze * std::pow(wavelengths[i], -1.3)));
    return sun_outside * through;
}

}  // namespace nacre
