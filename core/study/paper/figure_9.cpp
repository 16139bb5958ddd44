// Grooved metal at two orientations.
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

PaperResult make(const PaperTools& tools) {
    // A tile that lies leaning back, lit from above.
    const PaperView view{
        .object = "plate", .theta = 80, .phi = 90, .pitch = -42, .zoom = 1.3, .exposure = -0.5};
    PaperResult result;
    result.pictures = {png_picture("figure-9-across", "grooves across the viewing direction",
                                   draw_design(tools, paper_grooves(90), view)),
                       png_picture("figure-9-along", "grooves along the viewing direction",
                                   draw_design(tools, paper_grooves(0), view))};
    result.remarks = {
        "\"The angle of 40 degrees\" can be read as that between the two sides or as the tilt of each. "
        "Here it is between their normals: each side leans by 20 degrees, as in the preset Grooved metal.",
        "The paper's is a piece of metal; ours is a tile, a little domed, since light and viewer are both "
        "far "
        "away and a flat one would be of one brightness."};
    return result;
}

}  // namespace

const PaperPart figure_9_part{
    .name = "figure-9",
    .title = "Figure 9: grooved metal",
    .where = "fig. 9, sec. 6.2",
    .says =
        "Double highlights from a single light source for the same metallic grooved surface at two "
        "orientations of the grooves. Grooves are symmetrical with the angle of 40 degrees. ... The "
        "orientation of the grooves on the left is perpendicular to the viewing direction while on the "
        "right they are parallel.",
    .make = make};

}  // namespace nacre
