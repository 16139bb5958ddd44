// Satin and velvet on the same tablecloth.
#include <fmt/core.h>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/model/polar_angles.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

constexpr glm::dvec3 satin_albedo{0.12, 0.006, 0.018}, velvet_albedo{0.008, 0.0008, 0.003};

// Back toward the light, under eq. 14 and under eq. 13; the specular term.
PaperTable return_table(const PaperTools& tools) {
    Design design = paper_velvet(velvet_albedo);
    const Brdf correlated(bake(design, {}, tools.stop));
    design.shadowing.model = UncorrelatedMasking{};
    const Brdf uncorrelated(bake(design, {}, tools.stop));
    PaperTable table{{"velvet, straight back to the light, 1/sr", "eq. 13", "eq. 14", "eq. 14 over eq. 13"},
                     {}};
    for (const double theta : {30.0, 60.0, 80.0}) {
        const dvec3 k = polar_direction(theta, 0);
        const double product = uncorrelated.evaluate(k, k, Term::specular).y;
        const double here = correlated.evaluate(k, k, Term::specular).y;
        table.rows.push_back({fmt::format("\u03b8 = {:.0f}\u00b0", theta), fmt::format("{:.2g}", product),
                              fmt::format("{:.2g}", here), fmt::format("{:.2f}", here / product)});
    }
    return table;
}

PaperResult make(const PaperTools& tools) {
    const PaperView view{.object = "tablecloth", .theta = 18, .phi = 120, .zoom = 1.1, .exposure = 2};
    PaperResult result;
    result.pictures = {png_picture("figure-11-satin", "satin: 0.7 cylinders of 0.1 and 0.3 of 0.3",
                                   draw_design(tools, paper_satin(satin_albedo), view)),
                       png_picture("figure-11-velvet", "velvet: eq. 35 of 0.5 with the shadowing of eq. 14",
                                   draw_design(tools, paper_velvet(velvet_albedo), view))};
    result.tables = {return_table(tools)};
    result.remarks = {
        "The cloth is Nacre's own, fallen over a round table; the paper's is another simulation. Neither "
        "albedo is in the paper.",
        "With f0 = 5 % velvet's sheen is faint beside what light that goes from fibre to fibre would add; "
        "the preset Velvet has a higher, coloured f0 for that."};
    return result;
}

}  // namespace

const PaperPart figure_11_part{
    .name = "figure-11",
    .title = "Figure 11: satin and velvet",
    .where = "fig. 11, sec. 6.3 and 6.4",
    .says =
        "Synthetic satin (left) and velvet (right) tablecloths. The geometries are identical. ... "
        "Because retroreflection is one of the most pronounced reflection properties of velvet, we used "
        "the correlated form of shadowing term (Equation 14)",
    .make = make};

}  // namespace nacre
