// The error of the paper's table of g, which it does not give.
#include <fmt/core.h>

#include <cmath>

#include "core/bake/bake.h"
#include "core/model/polar_angles.h"
#include "core/plot/section_plots.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_grid.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

constexpr dvec2 shown{0.1, 1};

std::string place_text(const WorstError& worst) {
    const auto rounded = [](double angle) { return std::round(100 * angle) / 100; };
    return fmt::format("{} at ({}\u00b0, {}\u00b0)", percent_text(worst.error), rounded(worst.theta),
                       rounded(worst.phi));
}

std::vector<std::string> row_of(dvec2 sigma, const PaperTools& tools) {
    const auto tables = bake(paper_gaussian(sigma.x, sigma.y), {}, tools.stop);
    const auto error = [&](PaperPoints points) {
        return worst_error(*tables, paper_table(*tables->distribution, points, tools.stop), tools.stop);
    };
    return {fmt::format("({:g}, {:g})", sigma.x, sigma.y), place_text(error(PaperPoints::polar_20_quarter)),
            place_text(error(PaperPoints::polar_10_quarter)),
            place_text(error(PaperPoints::polar_10_hemisphere)),
            fmt::format("{} on {} nodes", percent_text(worst_error(*tables, tools.stop).error),
                        tables->size.w * tables->size.psi)};
}

// Along the azimuth at which the quarter's 200 points are worst.
Plot error_plot(const PaperTools& tools) {
    const auto tables = bake(paper_gaussian(shown.x, shown.y), {}, tools.stop);
    const auto stored = [&](PaperPoints points) {
        return paper_table(*tables->distribution, points, tools.stop);
    };
    const GridTable steep = stored(PaperPoints::polar_20_quarter),
                    quarter = stored(PaperPoints::polar_10_quarter);
    const GridTable whole = stored(PaperPoints::polar_10_hemisphere);
    const double phi = worst_error(*tables, steep, tools.stop).phi;
    CurvePlot plot =
        sampled({{.name = "20 x 10, a quarter", .ink = Ink::red},
                 {.name = "10 x 20, a quarter", .ink = Ink::second, .dash = Dash::dashed},
                 {.name = "10 x 20, all around", .ink = Ink::third, .dash = Dash::dotted},
                 {.name = "Nacre's table", .ink = Ink::first}},
                {.low = 0, .high = 89.9, .hints = {}}, [&](double theta, std::span<double> values) {
                    const dvec3 k = polar_direction(theta, phi);
                    const double exact = tables->distribution->area(k).g;
                    values[0] = 100 * area_error(tables->shading, k, steep.area(k), exact);
                    values[1] = 100 * area_error(tables->shading, k, quarter.area(k), exact);
                    values[2] = 100 * area_error(tables->shading, k, whole.area(k), exact);
                    values[3] = 100 * area_error(tables->shading, k, exact);
                });
    plot.x = angle_axis("angle of k from the normal, \u03b8", 0, 90);
    plot.y = value_axis("error of g (%)", "%", highest_of(plot.series), false);
    return curve_plot("Error of the stored g between its points, %",
                      fmt::format("\u03c3 = ({:g}, {:g}), \u03c6 = {:g}\u00b0", shown.x, shown.y, phi),
                      std::move(plot));
}

PaperResult make(const PaperTools& tools) {
    PaperTable table{{"\u03c3", "20 x 10 over a quarter", "10 x 20 over a quarter",
                      "10 x 20 over the hemisphere", "Nacre's table"},
                     {}};
    for (const dvec2 sigma : {dvec2{1, 1}, shown, {0.1, 0.2}, {0.01, 0.01}, {0.001, 1}})
        table.rows.push_back(row_of(sigma, tools));
    PaperResult result;
    result.pictures = {svg_picture("grid", "error along one azimuth", error_plot(tools))};
    result.tables = {std::move(table)};
    result.remarks = {
        "The worst error of g, and where (\u03b8, \u03c6). Points evenly in \u03b8 by \u03c6, bilinear, "
        "with exact g at each: what is seen is interpolation alone, and more accurate integration would "
        "not mend it. The paper does not say how its 200 points lie; the kindest layout is 20 x 10 over "
        "the quarter that suffices for two mirror planes.",
        "Narrow lobes bend g most near grazing, between the last two rings. Nacre stretches the directions "
        "by p's own width and chooses the size by the error that it measures (docs/accuracy.md)."};
    return result;
}

}  // namespace

const PaperPart grid_part{
    .name = "grid",
    .title = "The error of the table of 200 points",
    .where = "sec. 5.2",
    .says =
        "This allows us to compute values of both g(k) and R(k) on a very coarse grid using available "
        "numerical packages, store the results in a table and use bilinear interpolation during the "
        "rendering process. We have used a total of 200 grid points (for many distributions an even "
        "coarser grid should be sufficient).",
    .make = make};

}  // namespace nacre
