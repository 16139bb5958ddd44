// What is drawn over the picture of p.
#pragma once

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// Rings of theta and spokes of phi with their angles.
void draw_grid(const CanvasFrame& frame);

// An arrow from n to the mean normal of the facets: green where it is along n, amber where it leans.
void draw_mean_normal(const CanvasFrame& frame, const FacetDistribution& p);

// A cross at the normal that somebody points at elsewhere.
void draw_mark(const CanvasFrame& frame, dvec3 h);

// Angle of the mean normal from n, degrees.
double lean_of_mean(const FacetDistribution& p);

// From here on p counts as leaning, degrees.
inline constexpr double lean_noticed = 0.5;

}  // namespace nacre::ui
