// Lobes that are a function of theta alone: the inverse Gaussian (Ashikhmin 2000, eq. 35) and drawn curves.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

std::shared_ptr<const LobeModel> make_inverse_gaussian_lobe(const InverseGaussianLobe& lobe);
std::shared_ptr<const LobeModel> make_curve_lobe(const CurveLobe& lobe);

// The points as curve_density() of the shader reads them: theta in radians, value, theta, ...
std::vector<float> curve_data(const CurveLobe& lobe);

}  // namespace nacre
