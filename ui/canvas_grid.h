// What is drawn over the picture of p.
#pragma once

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// Rings of theta and spokes of phi with their angles.
void draw_grid(const CanvasFrame& frame);

// An arrow from n to the mean normal of the facets: green where it is along n, amber where it is tilted.
void draw_mean_normal(const CanvasFrame& frame, const FacetDistribution& p);

// A cross at the normal that somebody points at elsewhere.
void draw_mark(const CanvasFrame& frame, dvec3 h);

// Angle of the mean normal from n, degrees.
double tilt_of_mean(const FacetDistribution& p);

// From here on p counts as tilted, degrees.
inline constexpr double tilt_noticed = 0.5;

}  // namespace nacre::ui
