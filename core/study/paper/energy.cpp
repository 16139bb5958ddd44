// The directions in which slanted velvet sends out more than it gets.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/model/polar_angles.h"
#include "core/plot/section_plots.h"
#include "core/study/excess_energy.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

struct Form {
    const char* what;
    const char* paper;
    Series series;  // none of its own without a name
    SlantedMirrors mirrors;
    std::shared_ptr<const Tables> tables = nullptr;
};

std::vector<Form> forms(const PaperTools& tools) {
    std::vector<Form> all = {{"as published: sides lean by 50\u00b0, N doubled",
                              "14 of 200",
                              {.name = "as published, N doubled", .ink = Ink::red},
                              {}},
                             {"sides lean by 40\u00b0, N doubled", "-", {}, {.lean = 40}},
                             {"N as it is",
                              "-",
                              {.name = "N as it is", .ink = Ink::second, .dash = Dash::dashed},
                              {.mean_cosine_scale = 1}},
                             {"N doubled, P kept at most 1, as Nacre does",
                              "-",
                              {.name = "P at most 1, Nacre", .ink = Ink::first},
                              {.clamp = true}}};
    for (Form& form : all) form.tables = bake(slanted_mirrors(form.mirrors), {}, tools.stop);
    return all;
}

// Each by the rule that bakes R.
Plot albedo_plot(const std::vector<Form>& forms, const std::stop_token& stop) {
    std::vector<Series> series;
    std::vector<AlbedoQuadrature> rules;
    std::vector<const FacetDistribution*> p;
    for (const Form& form : forms) {
        if (form.series.name.empty()) continue;
        series.push_back(form.series);
        p.push_back(form.tables->distribution.get());
        rules.emplace_back(*p.back(), form.tables->shading, 0, 1e-3);
    }
    series.push_back({.name = "what comes in", .ink = Ink::quiet, .dash = Dash::dotted});
    CurvePlot plot = sampled(std::move(series), {.low = -89.5, .high = 89.5, .hints = {}},
                             [&](double theta, std::span<double> values) {
                                 if (stop.stop_requested()) throw BakeCancelled();
                                 const dvec3 k = polar_direction(std::fabs(theta), theta < 0 ? 180 : 0);
                                 for (std::size_t i = 0; i < rules.size(); ++i)
                                     values[i] = rules[i](k, p[i]->projected_area(k))[0];
                                 values[rules.size()] = 1;
                             });
    plot.x = angle_axis("angle of k from the normal, toward the lean of the fibres", -90, 90);
    plot.y = value_axis("directional albedo R, F = 1", "", highest_of(plot.series), false, 1);
    return curve_plot("Slanted velvet of perfect mirrors", "in the plane in which the fibres lean",
                      std::move(plot));
}

PaperResult make(const PaperTools& tools) {
    PaperTable table{
        {"slanted velvet, F = 1: directions with R > 1", "paper", "of 20 x 10", "of 10 x 20", "largest R"},
        {}};
    const std::vector<Form> all = forms(tools);
    for (const Form& form : all) {
        const ExcessEnergy steep = excess_energy(*form.tables, 20, 10, tools.stop);
        const ExcessEnergy flat = excess_energy(*form.tables, 10, 20, tools.stop);
        table.rows.push_back({form.what, form.paper, fmt::format("{}", steep.directions),
                              fmt::format("{}", flat.directions),
                              fmt::format("{:.3f}", std::max(steep.largest, flat.largest))});
    }
    PaperResult result;
    result.pictures = {svg_picture("energy", "R of the three", albedo_plot(all, tools.stop))};
    result.tables = {std::move(table)};
    result.remarks = {
        "The paper does not say where its 200 points lie. Here they are the middles of cells, 20 in \u03b8 "
        "by 10 in \u03c6 or 10 by 20.",
        "\"Slanted with the angle of about 40 degrees with respect to the geometric normal\" is said of "
        "the bundles. The normals of their sides are across them and lean by 50\u00b0; so the paper's "
        "count comes out. Nacre's presets Slanted velvet have p itself lean by 40\u00b0.",
        "With P at most 1 the proof of eq. 32 holds for every p: no direction exceeds 1."};
    return result;
}

}  // namespace

const PaperPart energy_part{
    .name = "energy",
    .title = "14 of 200 directions",
    .where = "sec. 6.4",
    .says =
        "This distribution is not physically realizable and, as a result, the energy conservation of the "
        "generated BRDF is not guaranteed. Computations of R(k) show that this quantity indeed exceeds "
        "one for 14 out of our 200 directional data points in the hypothetical case of perfectly "
        "reflecting (f0 = 1.0) fiber material",
    .make = make};

}  // namespace nacre
