// A web page that shows the design on a lit sphere: one file that needs nothing else.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

inline constexpr std::size_t web_page_max = 3u << 19;  // bytes: 1.5 MiB

struct WebPage {
    std::string html;
    bool half = false;   // all numbers of the tables are 16-bit floats
    double rounded = 0;  // what of the reflected light that and rounded pictures change; see rounding_error()
    std::string remark;  // what was left out so that it fits, in one sentence; mostly empty
};

// HTML with WebGL 2. It takes R from the tables for ambient light, which it does not offer without. A design
// whose pictures are too large is baked again with smaller ones. A UserError where even those are too
// large.
WebPage make_web_page(const Design& design, const Tables& tables);

// `html` of that.
std::string web_page(const Design& design, const Tables& tables);

// Where a page's numbers are rounded to 16-bit floats.
enum class Rounded { nothing, pictures, everything };
std::vector<float> rounded_data(const Tables& tables, Rounded what);

// The largest change of reflected light with other numbers in the place of the tables': relative, and to at
// least `least_radiance` under the page's lamp. Infinite where one of them is.
double rounding_error(const Tables& tables, const std::vector<float>& data);

inline constexpr double lamp_irradiance = 4.5;
inline constexpr double least_radiance = 0.01;  // below it a screen shows black

// What a picture's p loses where the pictures in the design become smaller: the largest change of p and the
// mean over the facets above the horizon, both of the largest p.
struct DensityChange {
    double worst = 0;
    double mean = 0;
};
DensityChange density_change(const FacetDistribution& before, const FacetDistribution& after);

}  // namespace nacre
