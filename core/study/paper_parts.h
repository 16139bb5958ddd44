// What the parts of the paper have in common.
#pragma once

#include <string>

#include "core/plot/plot.h"
#include "core/study/paper.h"

namespace nacre {

// "figure-5-ward.png"
PaperPicture png_picture(const std::string& name, std::string caption, const PaperImage& image);

// "figure-6-x.svg"
PaperPicture svg_picture(const std::string& name, std::string caption, const Plot& plot);

// Curves with their axes and a title.
Plot curve_plot(std::string title, std::string subtitle, CurvePlot curves);

// The design itself, baked and drawn.
PaperImage draw_design(const PaperTools& tools, const Design& design, const PaperView& view);

// Ward's model of these widths in the place of the design's specular term (eq. 5a of Ward 1992).
PaperImage draw_ward(const PaperTools& tools, const Design& design, dvec2 alpha, const PaperView& view);

std::string percent_text(double part);  // "11 %"

}  // namespace nacre
