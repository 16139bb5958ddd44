#include <fmt/core.h>

#include "core/bake/symmetry.h"
#include "core/study/harmonic_area.h"
#include "core/study/method.h"

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

Method harmonic_method(const Design& design, const std::stop_token& stop) {
    Method method{
        .kind = MethodKind::harmonics,
        .name = "spherical harmonics",
        .about =
            "g as harmonics of p, each times the clamped cosine's factor (Ramamoorthi & Hanrahan 2001): a "
            "second opinion that shares no formula with the tables",
        .albedo = false};
    const bool round = find_symmetry(design.distribution).symmetry == Symmetry::isotropic;
    const FacetDistribution distribution(design.distribution);
    const double left_over = HarmonicArea(distribution, degree_limit, round, stop).upper_half();
    if (left_over > most_left_over) {
        method.left_out =
            fmt::format("p is too narrow: degrees {} to {} still hold {:.1e} of g's norm, more than {:.0e}",
                        degree_limit / 2 + 1, degree_limit, left_over, most_left_over);
        return method;
    }
    for (int degree = 2; degree <= degree_limit; degree *= 2)
        method.settings.push_back({fmt::format("degree {}", degree),
                                   [&design, degree, round](Wanted, const std::stop_token& inner) {
                                       return make_table(design, degree, round, inner);
                                   }});
    return method;
}

std::vector<Method> all_methods(const Design& design, const std::stop_token& stop) {
    return {monte_carlo_method(design), cubature_method(design), plain_grid_method(design),
            stretched_method(design),   bake_method(design),     harmonic_method(design, stop)};
}

}  // namespace nacre
