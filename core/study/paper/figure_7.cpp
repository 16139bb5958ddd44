// Gold-painted plastic, Ward beside the paper's model.
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

PaperResult make(const PaperTools& tools) {
    const PaperView view{};
    // Ward's diffuse reflectance is a constant: here what a facet does not reflect straight on.
    Design ward = paper_painted_plastic();
    ward.diffuse = LambertianDiffuse{.kd = 0.95, .ks = 0.05, .albedo = gold_paint()};
    PaperResult result;
    result.pictures = {png_picture("figure-7-ward", "Ward 1992 with a Lambertian term, (0.1, 0.2)",
                                   draw_ward(tools, ward, {0.1, 0.2}, view)),
                       png_picture("figure-7-here", "the model: eq. 26 and 30",
                                   draw_design(tools, paper_painted_plastic(), view))};
    result.remarks = {
        "The two highlights cannot be told apart. The diffuse part differs near the edge and the shadow: "
        "the coupled term of eq. 30 fades where the highlight takes more, the Lambertian one does not.",
        "The paper does not give the colour of its paint; here it is (0.72, 0.43, 0.08), linear."};
    return result;
}

}  // namespace

const PaperPart figure_7_part{
    .name = "figure-7",
    .title = "Figure 7: gold-painted plastic, \u03c3 = (0.1, 0.2)",
    .where = "fig. 7, sec. 6.1",
    .says =
        "Note that the shape of highlight is nearly identical while there are some differences in the "
        "diffuse part of images which is due to Ward effectively using a simpler form (Equation 27) of "
        "the diffuse component.",
    .make = make};

}  // namespace nacre
