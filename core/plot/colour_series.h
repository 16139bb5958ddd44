// A colour as curves: one where it is grey, else one for each channel.
#pragma once

#include <string>
#include <vector>

#include "core/plot/plot.h"

namespace nacre {

bool is_grey(const dvec3& colour);

// Series of a quantity `name` without values yet; red, green and blue unless `grey`.
std::vector<Series> colour_series(const std::string& name, bool grey);

}  // namespace nacre
