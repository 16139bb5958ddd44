#include "core/fit/lobe_parameters.h"

#include <algorithm>
#include <cmath>

namespace nacre {

void keep_within(LobeParameters& parameters) {
    parameters[0] = std::min(parameters[0], std::log(weight_max));
    for (const std::size_t slope : {std::size_t{1}, std::size_t{2}})
        parameters[slope] = std::clamp(parameters[slope], -slope_max, slope_max);
    for (const std::size_t logarithm : {std::size_t{3}, std::size_t{5}})
        parameters[logarithm] = std::min(parameters[logarithm], -std::log(alpha_min));
    parameters[4] = std::clamp(parameters[4], -1 / alpha_min, 1 / alpha_min);
}

LobeFrame frame_of(const LobeParameters& parameters) {
    LobeFrame frame;
    frame.weight = std::exp(parameters[0]);
    turn_frame(frame, glm::normalize(glm::dvec3(parameters[1], parameters[2], 1)));
    const double a = std::exp(parameters[3]), b = parameters[4], c = std::exp(parameters[5]);
    frame.a11 = 1 + a * a;
    frame.a12 = a * b;
    frame.a22 = 1 + b * b + c * c;
    return frame;
}

LobeParameters parameters_of(const LobeFrame& frame) {
    constexpr double least = 1e-3, most = 1 / (alpha_min * alpha_min);  // eigenvalues of A - I
    const double middle = 0.5 * (frame.a11 + frame.a22), half = 0.5 * (frame.a11 - frame.a22);
    const double reach = std::hypot(half, frame.a12);
    const double high = std::clamp(middle + reach - 1, least, most);
    const double low = std::clamp(middle - reach - 1, least, most);
    const double scale = reach > 0 ? 0.5 * (high - low) / reach : 0;
    const double b11 = 0.5 * (high + low) + scale * half;
    const double a = std::sqrt(b11), b = scale * frame.a12 / a;
    const double c = std::sqrt(high * low / b11);  // of the determinant, whose difference form cancels
    return {std::log(std::max(frame.weight, 1e-9)),
            frame.N.x / frame.N.z,
            frame.N.y / frame.N.z,
            std::log(a),
            b,
            std::log(c)};
}

FrameGradient& FrameGradient::operator+=(const FrameGradient& other) {
    log_weight += other.log_weight;
    N += other.N;
    X += other.X;
    Y += other.Y;
    a11 += other.a11;
    a12 += other.a12;
    a22 += other.a22;
    return *this;
}

LobeParameters by_parameters(const LobeParameters& parameters, const FrameGradient& by_frame) {
    const LobeFrame frame = frame_of(parameters);
    const double a = std::exp(parameters[3]), b = parameters[4], c = std::exp(parameters[5]);
    LobeParameters gradient{};
    gradient[0] = by_frame.log_weight;
    const double length = std::sqrt(parameters[1] * parameters[1] + parameters[2] * parameters[2] + 1);
    const double across = std::hypot(frame.N.y, frame.N.z);
    for (int i = 0; i < 2; ++i) {
        glm::dvec3 axis(0);
        axis[i] = 1;
        const glm::dvec3 dN = (axis - frame.N * frame.N[i]) / length;
        const glm::dvec3 turned = glm::dvec3(0, dN.z, -dN.y) / across;
        const glm::dvec3 dY = turned - frame.Y * glm::dot(frame.Y, turned);
        const glm::dvec3 dX = glm::cross(dY, frame.N) + glm::cross(frame.Y, dN);
        gradient[static_cast<std::size_t>(1 + i)] =
            glm::dot(by_frame.N, dN) + glm::dot(by_frame.X, dX) + glm::dot(by_frame.Y, dY);
    }
    gradient[3] = by_frame.a11 * 2 * a * a + by_frame.a12 * a * b;
    gradient[4] = by_frame.a12 * a + by_frame.a22 * 2 * b;
    gradient[5] = by_frame.a22 * 2 * c * c;
    return gradient;
}

}  // namespace nacre
