#include "core/plot/section_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/model/polar_angles.h"

namespace nacre {

std::vector<double> shown_azimuths(const DistributionSymmetry& symmetry) {
    double step = 90;
    switch (symmetry.symmetry) {
        case Symmetry::isotropic:
            return {0};
        case Symmetry::quarter:
            step = 30;
            break;
        case Symmetry::half:
            step = 60;
            break;
        case Symmetry::none:
            break;
    }
    std::vector<double> azimuths;
    for (int i = 0; i < 4; ++i) azimuths.push_back(symmetry.axis + i * step);
    return azimuths;
}

std::string azimuth_name(double phi) { return fmt::format("\u03c6 {:.4g}\u00b0", phi); }

Ink azimuth_ink(std::size_t index) {
    constexpr Ink inks[] = {Ink::first, Ink::second, Ink::third, Ink::fourth};
    return inks[index];
}

double highest_of(const std::vector<Series>& series) {
    double highest = 0;
    for (const Series& one : series)
        for (const double value : one.values)
            if (std::isfinite(value)) highest = std::max(highest, value);
    return highest;
}

CurvePlot sampled(std::vector<Series> series, const CurveRange& range, const CurvesAt& values_at) {
    CurvePlot plot;
    SampledCurves samples = sample_curves(range, series.size(), values_at);
    plot.at = std::move(samples.at);
    for (std::size_t i = 0; i < series.size(); ++i) series[i].values = std::move(samples.values[i]);
    plot.series = std::move(series);
    return plot;
}

CurvePlot along_azimuths(const Tables& tables, const std::string& name, const CurveRange& range,
                         const std::function<double(dvec3)>& value_of) {
    const std::vector<double> azimuths = shown_azimuths(tables.needs.symmetry);
    std::vector<Series> series;
    if (azimuths.size() == 1) series = {{.name = name}};
    for (std::size_t i = 0; azimuths.size() > 1 && i < azimuths.size(); ++i)
        series.push_back({.name = azimuth_name(azimuths[i]), .ink = azimuth_ink(i)});
    return sampled(std::move(series), range, [&](double theta, std::span<double> values) {
        for (std::size_t i = 0; i < azimuths.size(); ++i)
            values[i] = value_of(polar_direction(theta, azimuths[i]));
    });
}

}  // namespace nacre
