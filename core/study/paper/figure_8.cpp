// Matt facets beside Oren and Nayar.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/compare/facet_slopes.h"
#include "core/model/facet_distribution.h"
#include "core/model/polar_angles.h"
#include "core/plot/section_plots.h"
#include "core/study/matt_facets.h"
#include "core/study/matt_sphere.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr glm::dvec3 clay{0.8, 0.72, 0.62};

// Oren and Nayar's functions for white facets (1994, eq. 27 and 28).
class OrenNayar {
  public:
    explicit OrenNayar(double sigma) {
        form_.model = Shading<double>::MODEL_OREN_NAYAR;
        form_.sigma2 = sigma * sigma;
    }

    double full(dvec3 k1, dvec3 k2) const { return of_albedo(1, k1, k2); }

    // Without their interreflection, which grows as the square of the albedo.
    double once(dvec3 k1, dvec3 k2) const { return 4 * of_albedo(0.5, k1, k2) - of_albedo(1, k1, k2); }

  private:
    double of_albedo(double albedo, dvec3 k1, dvec3 k2) const {
        Shading<double>::ClosedForm form = form_;
        form.rho = dvec3{albedo};
        return Shading<double>::oren_nayar(form, k1, k2).x;
    }

    Shading<double>::ClosedForm form_{};
};

struct Surfaces {
    RoundBrdf lambert, full, once, here;
};

Plot profile(const Surfaces& all, const PaperView& view, const std::stop_token& stop) {
    CurvePlot plot =
        sampled({{.name = "the model, eq. 33", .ink = Ink::first},
                 {.name = "Oren-Nayar, one bounce", .ink = Ink::second},
                 {.name = "Oren-Nayar, in full", .ink = Ink::red, .dash = Dash::dashed},
                 {.name = "Lambert", .ink = Ink::quiet, .dash = Dash::dotted}},
                {.low = -89, .high = 89, .hints = {}}, [&](double theta, std::span<double> values) {
                    if (stop.stop_requested()) throw BakeCancelled();
                    values[0] = sphere_radiance(all.here, view, theta);
                    values[1] = sphere_radiance(all.once, view, theta);
                    values[2] = sphere_radiance(all.full, view, theta);
                    values[3] = sphere_radiance(all.lambert, view, theta);
                });
    plot.x = angle_axis("angle of the normal from the viewer, toward the light", -90, 90);
    plot.y = {.title = "radiance over that of white paper", .unit = "", .low = 0, .high = 1.2};
    return curve_plot("Across the sphere in the plane of the light",
                      fmt::format("white facets, light {:.0f}\u00b0 from the viewer", view.theta),
                      std::move(plot));
}

// Root mean square over pairs of directions drawn by their cosines, of 1/pi.
double apart(const RoundBrdf& a, const RoundBrdf& b) {
    Random random(8);
    double sum = 0;
    constexpr int pairs = 2000;
    for (int i = 0; i < pairs; ++i) {
        const dvec3 k1 = cosine_sample(random), k2 = cosine_sample(random);
        const double off = a(k1, k2) - b(k1, k2);
        sum += off * off;
    }
    return pi * std::sqrt(sum / pairs);
}

PaperResult make(const PaperTools& tools) {
    const FacetDistribution p(paper_gaussian(1, 1).distribution);
    const MattFacets facets(p);
    const double sigma = oren_nayar_sigma(p);
    const OrenNayar theirs(sigma);
    const Surfaces all{[](dvec3, dvec3) { return 1 / pi; },
                       [&](dvec3 k1, dvec3 k2) { return theirs.full(k1, k2); },
                       [&](dvec3 k1, dvec3 k2) { return theirs.once(k1, k2); },
                       [&](dvec3 k1, dvec3 k2) { return facets.brdf(k1, k2); }};
    const PaperView view{.theta = 15, .phi = 135};
    PaperResult result;
    result.pictures = {
        png_picture("figure-8-oren-nayar", "Oren-Nayar, full functions",
                    draw_sphere(tools, all.full, clay, view)),
        png_picture("figure-8-here", "the model: eq. 33 by direct integration",
                    draw_sphere(tools, all.here, clay, view)),
        png_picture("figure-8-lambert", "Lambert, for comparison",
                    draw_sphere(tools, all.lambert, clay, view)),
        svg_picture("figure-8-profile", "radiance across the sphere", profile(all, view, tools.stop))};
    result.tables = {{{"root mean square distance from eq. 33, of 1/\u03c0", "here"},
                      {{"Oren-Nayar, one bounce", fmt::format("{:.3f}", apart(all.here, all.once))},
                       {"Oren-Nayar, in full", fmt::format("{:.3f}", apart(all.here, all.full))},
                       {"Lambert", fmt::format("{:.3f}", apart(all.here, all.lambert))}}}};
    result.remarks = {
        "Nacre has no such facets among its models: this sphere is direct integration, eq. 33 summed for "
        "each of its pixels over 8,192 facets of eq. 34's p, and not the preview's picture of a design.",
        fmt::format("The paper does not give the compatible parameters. Here \u03c3\u00b2 = "
                    "\u222b\u03b8\u00b2p/(2\u222bp), facets as steep in the mean square: \u03c3 = "
                    "{:.1f}\u00b0 for eq. 34 of 1.0.",
                    sigma * (180 / pi)),
        "Oren and Nayar's full functions hold one interreflection, which eq. 33 leaves out: that is why "
        "theirs is the brighter sphere. Without it the two are close."};
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
