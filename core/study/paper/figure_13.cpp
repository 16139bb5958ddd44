// Slanted velvet in two colours.
#include <fmt/core.h>

#include "core/bake/brdf.h"
#include "core/image/luminance.h"
#include "core/model/polar_angles.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

constexpr glm::dvec3 blue{0.003, 0.007, 0.05}, red{0.06, 0.002, 0.005};

// Light and viewer in one direction, on slopes to either side.
PaperTable side_table(const PaperTools& tools) {
    const Brdf brdf(tools.baker.bake(paper_slanted_velvet(blue), {}, tools.stop));
    PaperTable table{
        {"blue, light and viewer in one place: luminance", "fibres lean toward it", "away from it", "ratio"},
        {}};
    for (const double theta : {20.0, 40.0, 60.0}) {
        const auto radiance = [&](double phi) {
            const dvec3 k = polar_direction(theta, phi);
            return luminance(brdf.evaluate(k, k)) * k.z;
        };
        const double toward = radiance(0), away = radiance(180);
        table.rows.push_back({fmt::format("slope of {:.0f}\u00b0", theta), fmt::format("{:.4f}", toward),
                              fmt::format("{:.4f}", away), fmt::format("{:.2f}", toward / away)});
    }
    return table;
}

PaperResult make(const PaperTools& tools) {
    const PaperView view{.object = "tablecloth", .theta = 12, .phi = 90, .zoom = 1.1, .exposure = 1.5};
    PaperResult result;
    result.pictures = {
        png_picture("figure-13-blue", "midnight blue", draw_design(tools, paper_slanted_velvet(blue), view)),
        png_picture("figure-13-red", "crimson", draw_design(tools, paper_slanted_velvet(red), view))};
    result.tables = {side_table(tools)};
    result.remarks = {
        "Both are in the paper's own form: N doubled by hand and P not kept below 1, so that this surface "
        "creates energy (see below). The presets Slanted velvet keep P at most 1, and their fibres' sides "
        "lean by 40\u00b0 in place of 50.",
        "As the paper says of its own right picture, the dark side of red velvet shows the plain diffuse "
        "term; in real velvet light that has met several red fibres is a deep, dark red there."};
    return result;
}

}  // namespace

const PaperPart figure_13_part{
    .name = "figure-13",
    .title = "Figure 13: slanted velvet of two colours",
    .where = "fig. 13, sec. 6.4",
    .says =
        "The illumination and viewing directions are almost parallel but due to the slant of the fibers "
        "the left side of the tablecloth is substantially brighter than the right one. ... The right "
        "side of the red tablecloth does not look as it does for the real velvet.",
    .make = make};

}  // namespace nacre
