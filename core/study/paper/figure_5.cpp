// Brushed gold, Ward beside the paper's model.
#include <fmt/core.h>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/model/polar_angles.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"
#include "core/study/ward.h"

namespace nacre {
namespace {

// At the mirror direction, F = 1: Ward, the model.
PaperTable highlight_table(const PaperTools& tools) {
    const Brdf ours(bake(paper_gaussian(0.1, 1), {}, tools.stop));
    const auto form = ward_form({0.1, 1});
    PaperTable table{{"in the middle of the highlight, F = 1", "Ward", "here", "here over Ward"}, {}};
    for (const double theta : {0.0, 30.0, 60.0, 75.0}) {
        const dvec3 k1 = polar_direction(theta, 0), k2 = polar_direction(theta, 180);
        const double ward = ward_brdf(WardForm::published, form, k1, k2), here = ours.evaluate(k1, k2).x;
        table.rows.push_back({fmt::format("light at {:.0f}\u00b0, 1/sr", theta), fmt::format("{:.3f}", ward),
                              fmt::format("{:.3f}", here), fmt::format("{:.2f}", here / ward)});
    }
    return table;
}

PaperResult make(const PaperTools& tools) {
    const PaperView view{.exposure = 0.5};
    Design ward = paper_golden();
    ward.diffuse = NoDiffuse{};
    PaperResult result;
    result.pictures = {
        png_picture("figure-5-ward", "Ward 1992, eq. 5a, (0.1, 1.0)", draw_ward(tools, ward, {0.1, 1}, view)),
        png_picture("figure-5-here", "the model: eq. 26 and the metal's diffuse term",
                    draw_design(tools, paper_golden(), view))};
    result.tables = {highlight_table(tools)};
    result.remarks = {
        "The shape of the highlight is nearly the same, and the model's is brighter. The metal's diffuse "
        "term fills the rest of the sphere, which stays black with Ward's. Ward's reflectance is a "
        "constant; here both have Schlick's factor, so that only the highlight differs.",
        "The model's peak is higher at the normal already, because eq. 34 has fewer steep facets than the "
        "Gaussian of slopes that Ward's formula stands for; as light and eye lean, Ward's loses energy "
        "besides (fig. 6)."};
    return result;
}

}  // namespace

const PaperPart figure_5_part{
    .name = "figure-5",
    .title = "Figure 5: golden spheres, \u03c3 = (0.1, 1.0)",
    .where = "fig. 5, sec. 6.1",
    .says =
        "Note that the shape of highlight is nearly identical while there are some differences in the "
        "diffuse part of images ... In particular, for our metal sphere on Figure 5 the diffuse "
        "component appears automatically when there is enough energy left after single-bounce "
        "scattering. ... This figure also shows that the highlight is brighter for our BRDF.",
    .make = make};

}  // namespace nacre
