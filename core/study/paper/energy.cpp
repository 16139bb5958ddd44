// The directions in which slanted velvet sends out more than it gets.
#include <fmt/core.h>

#include <cmath>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/model/polar_angles.h"
#include "core/plot/section_plots.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"
#include "core/study/slanted_energy.h"

namespace nacre {
namespace {

Plot albedo_plot(const PaperTools& tools) {
    const auto brdf_of = [&](double scale, bool clamp) {
        return Brdf(bake(slanted_white(scale, clamp), {.albedo = true}, tools.stop));
    };
    const Brdf published = brdf_of(2, false), plain = brdf_of(1, false), clamped = brdf_of(2, true);
    CurvePlot plot =
        sampled({{.name = "as published, N doubled", .ink = Ink::red},
                 {.name = "N as it is", .ink = Ink::second, .dash = Dash::dashed},
                 {.name = "P at most 1, Nacre", .ink = Ink::first},
                 {.name = "what comes in", .ink = Ink::quiet, .dash = Dash::dotted}},
                {.low = -89.5, .high = 89.5, .hints = {}}, [&](double theta, std::span<double> values) {
                    const dvec3 k = polar_direction(std::fabs(theta), theta < 0 ? 180 : 0);
                    values[0] = published.albedo(k).x;
                    values[1] = plain.albedo(k).x;
                    values[2] = clamped.albedo(k).x;
                    values[3] = 1;
                });
    plot.x = angle_axis("angle of k from the normal, toward the lean of the fibres", -90, 90);
    plot.y = value_axis("directional albedo R, F = 1", "", highest_of(plot.series), false, 1);
    return curve_plot("Slanted velvet of perfect mirrors", "in the plane in which the fibres lean",
                      std::move(plot));
}

PaperResult make(const PaperTools& tools) {
    PaperTable table{{"slanted velvet, F = 1", "paper", "here", "largest R"}, {}};
    const auto add = [&](const char* what, const char* paper, double scale, bool clamp) {
        const AlbedoCheck check = slanted_energy(scale, clamp, tools.stop);
        table.rows.push_back({what, paper, fmt::format("{} of {}", check.violations, check.directions),
                              fmt::format("{:.3f}", check.worst)});
    };
    add("R > 1, as published: N doubled", "14 of 200", 2, false);
    add("the same with N as it is", "-", 1, false);
    add("P kept at most 1, as Nacre does", "-", 2, true);
    PaperResult result;
    result.pictures = {svg_picture("energy", "R of the three", albedo_plot(tools))};
    result.tables = {std::move(table)};
    result.remarks = {
        "Ours are 10 rings of 20 directions, the last at 89.5\u00b0. The paper does not say where its 200 "
        "points lie, and a "
        "count of directions depends on that; that some exceed 1, and which, does not.",
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
        "generated "
        "BRDF is not guaranteed. Computations of R(k) show that this quantity indeed exceeds one for 14 out "
        "of "
        "our 200 directional data points in the hypothetical case of perfectly reflecting (f0 = 1.0) fiber "
        "material.",
    .make = make};

}  // namespace nacre
