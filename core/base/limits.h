// Bounds that the file, the panels and the bake agree on.
#pragma once

#include <cstdint>
#include <limits>

namespace nacre::limits {

inline constexpr double width_min = 1e-5;  // sigma and alpha, slopes
inline constexpr double width_max = 1e5;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double weight_max = 1e30;
inline constexpr double mean_cosine_scale_min = 1e-3;
inline constexpr double mean_cosine_scale_max = 100;
inline constexpr double intensity_max = 4;      // of the specular term
inline constexpr double tilt_max = 180;         // degrees
inline constexpr double angle_max = 360;        // degrees, either sign: azimuth, rotation
inline constexpr double correlation_min = 0.1;  // degrees
inline constexpr double correlation_max = 180;
inline constexpr double ior_min = 1;
inline constexpr double ior_max = 10;
inline constexpr double eta_min = 1e-3;
inline constexpr double eta_max = 100;
inline constexpr double k_max = 100;
inline constexpr double film_ior_max = 4;
inline constexpr double film_thickness_max = 2000;  // nm
inline constexpr double film_optical_max = 10000;   // nm, of a stack: the sum of index times thickness
inline constexpr int film_layers_max = 8;
inline constexpr int fresnel_points_max = 64;
inline constexpr double coat_roughness_min = 0.01;
inline constexpr double coat_ior_min = 1.01;
inline constexpr double coat_ior_max = 3;
inline constexpr double coat_colour_min = 1e-3;
inline constexpr double smoothing_max = 30;    // degrees, of a map of normals or heights
inline constexpr double relief_max = 1000;     // percent of the width, either sign: a map of heights
inline constexpr double stamp_size_min = 0.5;  // degrees, of a layer made of a stamp
inline constexpr double stamp_size_max = 90;
inline constexpr int layers_max = 16;
inline constexpr int curve_points_max = 256;
inline constexpr int raster_max = 1024;   // pixels a side, as the bake uses it
inline constexpr int picture_max = 4096;  // pixels a side, as a file may have; averaged down
inline constexpr std::uintmax_t file_bytes_max = 256u << 20;  // of a design or a picture

}  // namespace nacre::limits
