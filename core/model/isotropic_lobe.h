// Lobes that are a function of theta alone: the inverse Gaussian (Ashikhmin 2000, eq. 35) and drawn curves.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

std::shared_ptr<const LobeModel> make_inverse_gaussian_lobe(const InverseGaussianLobe& lobe);
std::shared_ptr<const LobeModel> make_curve_lobe(const CurveLobe& lobe);

// The points as curve_density() of the shader reads them: theta in radians, value, theta, ... Values are
// taken by the power of two that brings the largest into [1, 2), so that no unit of p leaves a float's range.
std::vector<float> curve_data(const CurveLobe& lobe);

}  // namespace nacre
