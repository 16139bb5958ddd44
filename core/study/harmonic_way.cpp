#include <fmt/core.h>

#include "core/bake/symmetry.h"
#include "core/study/harmonic_area.h"
#include "core/study/way.h"

namespace nacre {
namespace {

constexpr int degree_limit = 64;
constexpr double most_left_over = 1e-3;  // of g's norm

StoredTable make_table(const Design& design, int degree, bool round, const std::stop_token& stop) {
    const FacetDistribution distribution(design.distribution);
    const auto area = std::make_shared<HarmonicArea>(distribution, degree, round, stop);
    return {.area = [area](dvec3 k) { return (*area)(k); }, .bytes = area->size() * sizeof(float)};
}

}  // namespace

Way harmonic_way(const Design& design, const std::stop_token& stop) {
    Way way{
        .kind = WayKind::harmonics,
        .name = "spherical harmonics",
        .about =
            "g as harmonics of p, each times the clamped cosine's factor (Ramamoorthi & Hanrahan 2001): a "
            "second opinion that shares no formula with the tables",
        .albedo = false};
    const bool round = find_symmetry(design.distribution).symmetry == Symmetry::isotropic;
    const FacetDistribution distribution(design.distribution);
    const double left_over = HarmonicArea(distribution, degree_limit, round, stop).upper_half();
    if (left_over > most_left_over) {
        way.left_out =
            fmt::format("p is too narrow: degrees {} to {} still hold {:.1e} of g's norm, more than {:.0e}",
                        degree_limit / 2 + 1, degree_limit, left_over, most_left_over);
        return way;
    }
    for (int degree = 2; degree <= degree_limit; degree *= 2)
        way.settings.push_back({fmt::format("degree {}", degree),
                                [&design, degree, round](Wanted, const std::stop_token& inner) {
                                    return make_table(design, degree, round, inner);
                                }});
    return way;
}

std::vector<Way> all_ways(const Design& design, const std::stop_token& stop) {
    return {monte_carlo_way(design), cubature_way(design), plain_grid_way(design),
            stretched_way(design),   bake_way(design),     harmonic_way(design, stop)};
}

}  // namespace nacre
