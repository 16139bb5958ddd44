#include "core/verify/table_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/bake/facet_tables.h"
#include "core/verify/close_albedo.h"
#include "core/verify/effort.h"
#include "core/verify/facet_oracle.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double grazing = 1e-5;  // the smallest c
constexpr double albedo_tolerance = 1e-5;
constexpr double albedo_seconds = 12;  // of the processor, for R; no fewer than least_albedos directions
constexpr int least_albedos = 4;
constexpr double claim_slack = 1.25;  // between the bake's directions the error may be so much larger

// Of matt facets, of each probe and the one after the next.
TableError facet_errors(const Tables& tables, const Reference& reference, int count,
                        const std::stop_token& stop) {
    const FacetOracle oracle(reference);
    const std::vector<dvec3> probes = probe_directions(count);
    std::vector<double> errors;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const dvec3 a = probes[i], b = probes[(i + 2) % probes.size()];
        errors.push_back(facet_error(tables.shading, a, b, oracle.product(a, b, stop)));
    }
    return summarise(errors);
}

}  // namespace

std::vector<dvec3> probe_directions(int count) {
    std::vector<dvec3> directions;
    for (int i = 0; i < count; ++i) {
        // Evenly over theta, and every fourth one close to the horizon, evenly over the logarithm of c.
        const double part = (i + 0.5) / count;
        const double c = i % 4 == 3
                             ? grazing * std::pow(0.1 / grazing, 1 - (i / 4 + 1.0) / std::max(count / 4, 1))
                             : std::cos(0.5 * pi * part);
        const double phi = 2 * pi * std::fmod((i + 0.5) * std::numbers::phi, 1.0);
        const double sine = std::sqrt((1 - c) * (1 + c));
        directions.push_back({sine * std::cos(phi), sine * std::sin(phi), c});
    }
    return directions;
}

TableErrors measure_table_errors(const Tables& tables, const Reference& reference, std::stop_token stop,
                                 const ProbeCounts& counts, const std::function<void(double)>& progress) {
    TableErrors result;
    std::vector<double> errors;
    for (const dvec3 k : probe_directions(counts.area))
        errors.push_back(area_error(tables.shading, k, reference.projected_area(k)));
    result.area = summarise(errors);
    if (tables.shading.kinds.matt_facets())
        result.facets = facet_errors(tables, reference, counts.albedo, stop);
    if (!tables.needs.albedo) return result;
    const std::vector<dvec3> probes = probe_directions(counts.albedo);
    errors.assign(probes.size(), 0);
    const CloseAlbedo albedo(reference, albedo_tolerance);
    const auto probe = [&](int i) {
        if (stop.stop_requested()) throw BakeCancelled();
        const dvec3 k = probes[static_cast<std::size_t>(i)];
        errors[static_cast<std::size_t>(i)] =
            albedo_error(tables.shading, k, albedo(k, stop), tables.needs.fresnel_tables);
    };
    const int done = visit_within(albedo_seconds, counts.albedo, least_albedos, probe, progress);
    errors.resize(static_cast<std::size_t>(done));
    result.albedo = summarise(errors);
    return result;
}

double allowed_error(const TableError& claim, double tolerance) {
    return worse_error(tolerance, claim_slack * claim.worst);
}

}  // namespace nacre
