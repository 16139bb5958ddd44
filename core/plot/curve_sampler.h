// Abscissae that lie dense where a curve bends.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace nacre {

struct SampledCurves {
    std::vector<double> at;                   // rising, both ends among them
    std::vector<std::vector<double>> values;  // of each curve
};

// The values of all curves at one abscissa.
using CurvesAt = std::function<void(double x, std::span<double> values)>;

struct CurveRange {
    double low, high;
    std::vector<double> hints;  // where there may be a peak narrower than the first samples' distance
    bool logarithmic = false;   // small values count as much as large ones, four decades down
};

// Halves intervals until every curve lies within half a percent of its own largest value (logarithmic: of
// itself) from its chords' middles.
SampledCurves sample_curves(const CurveRange& range, std::size_t curves, const CurvesAt& values_at);

}  // namespace nacre
