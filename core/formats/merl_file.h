// The measured isotropic BRDFs of MERL (Matusik et al. 2003) as a file.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <stop_token>
#include <string>

#include "core/formats/export_format.h"

namespace nacre {

// Bins of theta_h, theta_d and phi_d. theta_h is finer near n: its bin is 90 sqrt(theta_h/90 degrees).
inline constexpr int merl_theta_h = 90, merl_theta_d = 90, merl_phi_d = 180;

// What a stored number is for each 1/sr, by colour.
inline constexpr glm::dvec3 merl_scale{1500.0, 1500.0 / 1.15, 1500.0 / 1.66};

struct MerlPair {
    glm::dvec3 k1, k2;
};

// The directions at places of the bins: index + 0.5 is a bin's centre. One may lie below the horizon.
MerlPair merl_pair(double theta_h, double theta_d, double phi_d);

// The design's BRDF at `part` of each bin: 0.5 is its centre and 0 its lower edge. Where a direction is not
// above the horizon it holds -1. 34,992,012 bytes. Throws BakeCancelled.
ExportWriter merl_writer(const Design& design, const ExportSettings& settings, double part,
                         const std::stop_token& stop, const std::function<void(double)>& progress);

}  // namespace nacre
