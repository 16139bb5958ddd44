// Plots as files.
#pragma once

#include <filesystem>
#include <string>

#include "core/plot/draw_plot.h"
#include "core/plot/point_plot.h"

namespace nacre {

// Well-formed XML in UTF-8, about 1,000 x 620 pixels.
std::string plot_svg(const Plot& plot, const ShapeView& view = {});

// The same, about 1,200 x 680 pixels.
std::string plot_svg(const PointPlot& plot);

// RFC 4180 with a header; angles in degrees, every number with as many digits as tell it from all others. A
// row for each abscissa of the curves, each k2 of a shape and each cell of a slice.
std::string plot_csv(const Plot& plot);

// A UserError of `file` unless it ends in .svg or .csv.
void check_plot_file(const std::filesystem::path& file);

// The one of the two that the file's extension asks for, .svg or .csv; see check_plot_file().
std::string plot_text(const std::filesystem::path& file, const Plot& plot, const ShapeView& view = {});

// As a file, whole or not at all.
void write_plot(const std::filesystem::path& file, const Plot& plot, const ShapeView& view = {});

}  // namespace nacre
