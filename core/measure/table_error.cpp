#include "core/measure/table_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bake.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double grazing = 1e-5;  // the smallest c

double albedo_error(const Tables& tables, const Reference& reference, dvec3 k, const std::stop_token& stop) {
    const AlbedoValues truth = reference.albedo(k, stop), read = baked_albedo(tables, k);
    double error = 0;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(tables.plan.fresnel_tables); ++i)
        error = std::fmax(error, std::fabs(read[i] - truth[i]));
    return error;
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

AlbedoValues baked_albedo(const Tables& tables, dvec3 k) {
    const Shading<double>& shading = tables.shading;
    const auto spot = shading.table_spot(k);
    const double full = shading.full_albedo(spot);
    const double kept = shading.clamped_part(k, shading.projected_area(k, spot));
    const int channels = tables.plan.fresnel_tables;
    const dvec3 f = channels == 1 ? dvec3{Shading<double>::schlick_weight(k.z)} : shading.fresnel(k.z);
    AlbedoValues values{full * kept};
    for (int c = 0; c < channels; ++c)
        values[static_cast<std::size_t>(c + 1)] = shading.fresnel_albedo(spot, full, f[c], c) * kept;
    return values;
}

TableError summarise(const std::vector<double>& errors) {
    TableError error{.directions = static_cast<int>(errors.size())};
    for (const double e : errors) {
        error.worst = std::fmax(error.worst, e);
        error.root_mean_square += e * e / error.directions;
    }
    error.root_mean_square = std::sqrt(error.root_mean_square);
    return error;
}

TableErrors measure_table_errors(const Tables& tables, const Reference& reference, std::stop_token stop,
                                 const ProbeCounts& counts) {
    TableErrors result;
    std::vector<double> errors;
    for (const dvec3 k : probe_directions(counts.area))
        errors.push_back(area_error(tables.shading, k, reference.projected_area(k)));
    result.area = summarise(errors);
    if (!tables.plan.albedo) return result;
    const std::vector<dvec3> probes = probe_directions(counts.albedo);
    errors.assign(probes.size(), 0);
    tbb::parallel_for(std::size_t{0}, probes.size(), [&](std::size_t i) {
        if (stop.stop_requested()) throw BakeCancelled();
        errors[i] = albedo_error(tables, reference, probes[i], stop);
    });
    result.albedo = summarise(errors);
    return result;
}

}  // namespace nacre
