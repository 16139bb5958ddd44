// Unusual distributions: a Gaussian multiplied by a picture.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"
#include "core/verify/albedo_check.h"

namespace nacre {
namespace {

constexpr glm::dvec3 silver{0.95, 0.93, 0.88}, copper{0.95, 0.64, 0.54};  // Hoffman 2012, table 1

// How far two pictures are apart, of 255.
double farthest(const PaperImage& a, const PaperImage& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        most = std::fmax(most, 255.0 * std::fabs(a.rgb[i] - b.rgb[i]));
    return most;
}

std::vector<std::string> row_of(const char* name, Design design, const PaperTools& tools) {
    design.fresnel = NoFresnel{};
    design.diffuse = NoDiffuse{};
    design.shadowing.clamp = false;
    const auto tables = bake(design, {}, tools.stop);
    const AlbedoCheck check = measure_albedo(*tables, Reference(design), tools.stop);
    const double lean = std::atan2(std::hypot(tables->mean.x, tables->mean.y), tables->mean.z);
    return {name, fmt::format("{:.1f}\u00b0", lean * (180 / std::numbers::pi)),
            fmt::format("{:.3f}", check.worst), fmt::format("{} of {}", check.violations, check.directions)};
}

PaperResult make(const PaperTools& tools) {
    const Design star = paper_unusual("Star", silver), heart = paper_unusual("Heart", copper);
    PaperView view{};
    const PaperImage before = draw_design(tools, star, view);
    PaperView turned = view;
    turned.yaw = 65;
    PaperResult result;
    result.pictures = {
        png_picture("figure-1-star", "a Gaussian of 0.9 times a star, whose mean normal is n", before),
        png_picture("figure-1-heart", "the same Gaussian times a heart, whose mean normal leans",
                    draw_design(tools, heart, view))};
    result.tables = {{{"p", "mean normal leans by", "largest R, F = 1", "directions with R > 1"},
                      {row_of("star", star, tools), row_of("heart", heart, tools)}}};
    result.remarks = {fmt::format("Turned by 65\u00b0 about its axis, the star's sphere makes a picture that "
                                  "differs from the first by {:.0f} of 255 at the most: the highlight "
                                  "stays.",
                                  farthest(before, draw_design(tools, star, turned))),
                      "A symmetric p creates no energy, as the paper says. A leaning one may: what the "
                      "paper noticed is not a rule. Nacre keeps P at most 1 unless told otherwise, and "
                      "then no p does; R in the table is without that, in the paper's own form.",
                      "The paper does not say which pictures it took. Ours are two of Nacre's stamps."};
    return result;
}

}  // namespace

const PaperPart figure_1_part{
    .name = "figure-1",
    .title = "Figure 1: unusual distributions",
    .where = "fig. 1, sec. 6.5",
    .says =
        "The only illumination is a small distant source, and the highlights will stay unchanged if the "
        "spheres rotate about the axes through their north and south poles. ... As long as the "
        "modulation is symmetric enough to keep the average vector in the normal direction (such as the "
        "distribution used for the image on the left of Figure 1), the BRDF will be energy conserving. A "
        "more general modulation may result in (h) no longer parallel to n but in practice we notice "
        "that as long as this effect is not very strong, the energy conservation is not affected.",
    .make = make};

}  // namespace nacre
