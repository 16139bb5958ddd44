#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "core/study/grid_table.h"
#include "core/verify/bare_surface.h"

namespace nacre {
namespace {

using std::numbers::pi;

// Columns: any two tangents and k.
glm::dmat3 frame_about(dvec3 k) {
    const dvec3 other = std::fabs(k.z) < 0.5 ? dvec3{0, 0, 1} : dvec3{1, 0, 0};
    const dvec3 x = glm::normalize(glm::cross(other, k));
    return {x, glm::cross(k, x), k};
}

// g = integral of (h.k)+ p dh: each facet adds pi p(h).
double sample_area(const FacetDistribution& distribution, dvec3 k, int samples, Random& random) {
    const glm::dmat3 frame = frame_about(k);
    double sum = 0;
    for (int i = 0; i < samples; ++i) sum += distribution.density(frame * cosine_sample(random));
    return pi * sum / samples;
}

// R = integral of rho c' dk': each direction adds pi rho(k, k'), with g read from the table.
AlbedoValues sample_albedo(const Shading<double>& shading, const GridTable& table, dvec3 k, double g,
                           int samples, Random& random) {
    AlbedoValues sum{};
    for (int i = 0; i < samples; ++i) {
        const dvec3 k2 = cosine_sample(random);
        const double full = shading
                                .specular(Shading<double>::known_direction(k, g, dvec3{0}),
                                          Shading<double>::known_direction(k2, table.area(k2), dvec3{0}))
                                .x;
        sum[0] += full;
        sum[1] += full * Shading<double>::schlick_weight(std::fmin(0.5 * glm::length(k + k2), 1.0));
    }
    return {pi * sum[0] / samples, pi * sum[1] / samples};
}

StoredTable make_table(const Design& design, int samples, Wanted wanted, const std::stop_token& stop) {
    BareSurface surface(design);
    surface.shading.kinds.fresnel = kind_index<Fresnel, NoFresnel>();
    const auto table = std::make_shared<GridTable>(
        PlainGrid(paper_polar, paper_azimuths, find_symmetry(design.distribution)));
    table->fill_area(
        [&](int node, dvec3 k) {
            Random random(static_cast<unsigned>(node));
            return sample_area(surface.distribution, k, samples, random);
        },
        stop);
    if (wanted == Wanted::area_and_albedo)
        table->fill_albedo(
            [&](int node, dvec3 k, double g) {
                Random random(static_cast<unsigned>(node));
                return sample_albedo(surface.shading, *table, k, g, samples, random);
            },
            stop);
    return GridTable::stored(table);
}

}  // namespace

Method monte_carlo_method(const Design& design) {
    Method method{
        .kind = MethodKind::monte_carlo,
        .name = "200-point grid, Monte Carlo",
        .about =
            "the paper's 10 x 20 grid in theta and phi, bilinear; every node from so many samples, facets "
            "drawn by the cosine about k for g, directions by the cosine about n for R"};
    for (int samples = 16; samples <= 1 << 18; samples *= 4)
        method.settings.push_back({fmt::format("{} samples a node", samples),
                                   [&design, samples](Wanted wanted, const std::stop_token& stop) {
                                       return make_table(design, samples, wanted, stop);
                                   }});
    return method;
}

}  // namespace nacre
