#include <fmt/core.h>

#include "core/base/csv_field.h"
#include "core/formats/plot_files.h"
#include "core/model/polar_angles.h"

namespace nacre {
namespace {

// The shortest digits that read back as the same number.
void append(std::string& text, double value) { text += fmt::format(",{}", value + 0.0); }

std::string header_of(const Axis& axis) {
    return csv_field(axis.unit.empty() ? axis.title : axis.title + ", " + axis.unit);
}

void append_colour(std::string& text, const dvec3& colour) {
    for (int c = 0; c < 3; ++c) append(text, colour[c]);
    text += "\r\n";
}

std::string csv_of(const CurvePlot& plot) {
    std::string text = header_of(plot.x);
    const std::string unit = plot.y.unit.empty() ? "" : ", " + plot.y.unit;
    for (const Series& series : plot.series) text += "," + csv_field(series.name + unit);
    text += "\r\n";
    for (std::size_t i = 0; i < plot.at.size(); ++i) {
        text += fmt::format("{}", plot.at[i]);
        for (const Series& series : plot.series) append(text, series.values[i]);
        text += "\r\n";
    }
    return text;
}

std::string csv_of(const LobePlot& plot) { return csv_of(plot.curves); }

std::string csv_of(const ShapePlot& plot) {
    std::string text = "theta2,phi2,red,green,blue\r\n";
    for (std::size_t i = 0; i < plot.k2.size(); ++i) {
        text += fmt::format("{},{}", polar_angle(plot.k2[i]), azimuth(plot.k2[i]));
        append_colour(text, plot.values[i]);
    }
    return text;
}

std::string csv_of(const SlicePlot& plot) {
    std::string text = "theta_h,theta_d,red,green,blue\r\n";
    for (int row = 0; row < plot.side; ++row)
        for (int column = 0; column < plot.side; ++column) {
            text += fmt::format("{},{}", plot.angle(column), plot.angle(row));
            append_colour(text, plot.values[static_cast<std::size_t>(row * plot.side + column)]);
        }
    return text;
}

}  // namespace

std::string plot_csv(const Plot& plot) {
    return std::visit([](const auto& contents) { return csv_of(contents); }, plot.contents);
}

}  // namespace nacre
