// Matt facets beside Oren and Nayar.
#include <fmt/core.h>

#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/bake/bake.h"
#include "core/compare/facet_slopes.h"
#include "core/model/facet_distribution.h"
#include "core/model/polar_angles.h"
#include "core/plot/section_plots.h"
#include "core/study/matt_sphere.h"
#include "core/study/oren_nayar_fit.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr glm::dvec3 clay{0.8, 0.72, 0.62};

// White matt facets of a design: after one bounce, which is eq. 33, and after all.
class MattSurface {
  public:
    explicit MattSurface(Design design) {
        design.diffuse = FacetDiffuse{.kd = 1, .ks = 0, .albedo = glm::dvec3{1}};
        tables_ = bake(design);
    }

    double once(dvec3 k1, dvec3 k2) const {
        const Shading<double>& shading = tables_->shading;
        return shading.facet_visibility(shading.direction(k1), shading.direction(k2), shading.facet_spot(k1),
                                        shading.facet_spot(k2)) /
               pi;
    }
    double full(dvec3 k1, dvec3 k2) const {
        const Shading<double>& shading = tables_->shading;
        return shading.diffuse(shading.direction(k1), shading.direction(k2)).x;
    }
    const FacetDistribution& p() const { return *tables_->distribution; }

  private:
    std::shared_ptr<const Tables> tables_;
};

struct Surfaces {
    RoundBrdf lambert, their_once, their_full, once, full;
};

Plot profile(const Surfaces& all, const PaperView& view, const std::stop_token& stop) {
    CurvePlot plot =
        sampled({{.name = "one bounce, eq. 33", .ink = Ink::first},
                 {.name = "Oren-Nayar, one bounce", .ink = Ink::second},
                 {.name = "all bounces", .ink = Ink::first, .dash = Dash::dashed},
                 {.name = "Oren-Nayar, in full", .ink = Ink::red, .dash = Dash::dashed},
                 {.name = "Lambert", .ink = Ink::quiet, .dash = Dash::dotted}},
                {.low = -89, .high = 89, .hints = {}}, [&](double theta, std::span<double> values) {
                    if (stop.stop_requested()) throw BakeCancelled();
                    values[0] = sphere_radiance(all.once, view, theta);
                    values[1] = sphere_radiance(all.their_once, view, theta);
                    values[2] = sphere_radiance(all.full, view, theta);
                    values[3] = sphere_radiance(all.their_full, view, theta);
                    values[4] = sphere_radiance(all.lambert, view, theta);
                });
    plot.x = angle_axis("angle of the normal from the viewer, toward the light", -90, 90);
    plot.y = {.title = "radiance over that of white paper", .unit = "", .low = 0, .high = 1.2};
    return curve_plot("Across the sphere in the plane of the light",
                      fmt::format("white facets, light {:.0f}\u00b0 from the viewer", view.theta),
                      std::move(plot));
}

PaperResult make(const PaperTools& tools) {
    const MattSurface here(paper_gaussian(1, 1));
    const double sigma = oren_nayar_sigma(here.p());
    const OrenNayar theirs(sigma);
    const Surfaces all{[](dvec3, dvec3) { return 1 / pi; },
                       [&](dvec3 k1, dvec3 k2) { return theirs.once(k1, k2); },
                       [&](dvec3 k1, dvec3 k2) { return theirs.full(k1, k2); },
                       [&](dvec3 k1, dvec3 k2) { return here.once(k1, k2); },
                       [&](dvec3 k1, dvec3 k2) { return here.full(k1, k2); }};
    const PaperView view{.theta = 15, .phi = 135};
    PaperResult result;
    result.pictures = {
        png_picture("figure-8-oren-nayar", "Oren-Nayar, full functions",
                    draw_sphere(tools, all.their_full, clay, view)),
        png_picture("figure-8-here", "matt facets, all bounces", draw_sphere(tools, all.full, clay, view)),
        png_picture("figure-8-lambert", "Lambert, for comparison",
                    draw_sphere(tools, all.lambert, clay, view)),
        svg_picture("figure-8-profile", "radiance across the sphere", profile(all, view, tools.stop))};
    const auto row = [](const char* what, double distance) {
        return std::vector<std::string>{what, fmt::format("{:.3f}", distance)};
    };
    result.tables = {{{"root mean square distance, of 1/\u03c0", "here"},
                      {row("one bounce, eq. 33, from Oren-Nayar's", apart(all.once, all.their_once)),
                       row("all bounces from Oren-Nayar's full functions", apart(all.full, all.their_full)),
                       row("one bounce from Lambert", apart(all.once, all.lambert))}}};
    result.remarks = {
        fmt::format("The paper does not give the compatible parameters. Here \u03c3\u00b2 = "
                    "\u222b\u03b8\u00b2p/(2\u222bp), facets as steep in the mean square: \u03c3 = "
                    "{:.1f}\u00b0 for eq. 34 of 1.0. Their single bounce comes closest at {:.1f}\u00b0.",
                    sigma * (180 / pi), closest_sigma(all.once) * (180 / pi)),
        "Eq. 33 is one bounce. Both spheres hold what facets send to each other: Oren and Nayar one "
        "interreflection, ours all of them, so that white facets lose nothing."};
    return result;
}

}  // namespace

const PaperPart figure_8_part{
    .name = "figure-8",
    .title = "Figure 8: matt facets, \u03c3 = 1.0",
    .where = "fig. 8, sec. 5.4 and 6.1",
    .says =
        "Gaussian spheres with Lambertian microfacets. Right: new model with \u03c3x = \u03c3y = 1.0. "
        "Left: Oren-Nayar with compatible parameters. ... Both BRDFs have the tendency to make objects "
        "appear \u2018flatter\u2019 than the Lambertian BRDF due to increased retroreflection.",
    .make = make};

}  // namespace nacre
