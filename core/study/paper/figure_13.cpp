// Slanted velvet in two colours.
#include <fmt/core.h>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/model/polar_angles.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

constexpr glm::dvec3 blue{0.006, 0.014, 0.1}, red{0.13, 0.004, 0.01};

// Light and viewer in one direction, on slopes to either side.
PaperTable side_table(const PaperTools& tools) {
    const Brdf brdf(bake(paper_slanted_velvet(blue), {}, tools.stop));
    PaperTable table{
        {"specular radiance, light and viewer above", "fibres lean toward it", "away from it", "ratio"}, {}};
    for (const double theta : {20.0, 40.0, 60.0}) {
        const auto radiance = [&](double phi) {
            const dvec3 k = polar_direction(theta, phi);
            return brdf.evaluate(k, k, Term::specular).y * k.z;
        };
        const double toward = radiance(0), away = radiance(180);
        table.rows.push_back({fmt::format("slope of {:.0f}\u00b0", theta), fmt::format("{:.4f}", toward),
                              fmt::format("{:.2g}", away),
                              away > 0 ? fmt::format("{:.3g}", toward / away) : "-"});
    }
    return table;
}

PaperResult make(const PaperTools& tools) {
    const PaperView view{.object = "tablecloth", .theta = 12, .phi = 90, .zoom = 1.1, .exposure = 0.8};
    PaperResult result;
    result.pictures = {
        png_picture("figure-13-blue", "midnight blue", draw_design(tools, paper_slanted_velvet(blue), view)),
        png_picture("figure-13-red", "crimson", draw_design(tools, paper_slanted_velvet(red), view))};
    result.tables = {side_table(tools)};
    result.remarks = {
        "Both are in the paper's own form: N doubled by hand and P not kept below 1, so that this surface "
        "creates "
        "energy (see below). The presets Slanted velvet keep P at most 1.",
        "As the paper says of its own right picture, the dark side of red velvet shows the plain diffuse "
        "term; in "
        "real velvet light that has met several red fibres is a deep, dark red there."};
    return result;
}

}  // namespace

const PaperPart figure_13_part{
    .name = "figure-13",
    .title = "Figure 13: slanted velvet of two colours",
    .where = "fig. 13, sec. 6.4",
    .says =
        "The illumination and viewing directions are almost parallel but due to the slant of the fibers the "
        "left "
        "side of the tablecloth is substantially brighter than the right one. The right side of the red "
        "tablecloth does not look as it does for the real velvet.",
    .make = make};

}  // namespace nacre
