// What plots over one angle have in common.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/plot/curve_sampler.h"
#include "core/plot/plot.h"

namespace nacre {

// As few azimuths as show what the symmetry leaves open: from a mirror plane on, where there is one.
std::vector<double> shown_azimuths(const DistributionSymmetry& symmetry);

std::string azimuth_name(double phi);
Ink azimuth_ink(std::size_t index);  // of shown_azimuths()

// The largest finite value, at least 0.
double highest_of(const std::vector<Series>& series);

// The series with their values over a range; the axes are left to the caller.
CurvePlot sampled(std::vector<Series> series, const CurveRange& range, const CurvesAt& values_at);

// The same of one quantity along each of the shown azimuths.
CurvePlot along_azimuths(const Tables& tables, const std::string& name, const CurveRange& range,
                         const std::function<double(dvec3)>& value_of);

}  // namespace nacre
