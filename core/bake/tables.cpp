#include "core/bake/tables.h"

#include <algorithm>
#include <cmath>

namespace nacre {

std::size_t Tables::table_floats() const {
    const std::size_t area = static_cast<std::size_t>(size.psi) * static_cast<std::size_t>(size.w);
    const std::size_t albedos = needs.albedo ? static_cast<std::size_t>(needs.layout().size()) : 0;
    const std::size_t albedo = static_cast<std::size_t>(size.rho) * static_cast<std::size_t>(size.v);
    const auto& shape = shading.surface.tables;
    const auto facets = static_cast<std::size_t>(shape.facet_nodes * shape.facet_rows *
                                                 (shape.facet_classes * shape.facet_terms + 1));
    const auto coat =
        static_cast<std::size_t>(shape.coat_albedo_nodes + 6 * shape.coat_nodes * shape.coat_rows);
    return area + albedos * albedo + facets + coat + (bounces ? bounces->floats : 0);
}

double area_error(const Shading<double>& shading, dvec3 k, double exact) {
    return area_error(shading, k, shading.projected_area(k, shading.table_spot(k)), exact);
}

double area_error(const Shading<double>& shading, dvec3 k, double read, double exact) {
    const double floor = shading.kinds.clamp ? shading.surface.N * k.z : 0;
    const double width = shading.table_spot(k).q;
    if (std::isnan(read + exact + floor + width)) return limits::infinity;
    const double divisor = std::max({exact, floor, 0.05 * width});
    return divisor > 0 ? std::fabs(std::max(read, floor) - std::max(exact, floor)) / divisor : 0;
}

AlbedoValues read_albedo(const Shading<double>& shading, dvec3 k, int channels) {
    const AlbedoLayout layout{channels, shading.kinds.tint};
    const auto spot = shading.table_spot(k);
    const auto albedo = shading.albedo_spot(k, spot);
    const dvec3 full = shading.colour_albedo_f1(albedo);
    const double kept = shading.clamped_part(k, shading.projected_area(k, spot));
    const dvec3 f = channels == 1 ? dvec3{Shading<double>::schlick_weight(k.z)} : shading.fresnel(k.z);
    AlbedoValues values{};
    for (int c = 0; c < layout.full(); ++c) values[static_cast<std::size_t>(c)] = full[c] * kept;
    for (int c = 0; c < layout.factors(); ++c)
        values[static_cast<std::size_t>(layout.full() + c)] =
            shading.fresnel_albedo(albedo, full[c], f[c], c) * kept;
    return values;
}

double albedo_error(const Shading<double>& shading, dvec3 k, const AlbedoValues& exact, int channels) {
    const AlbedoLayout layout{channels, shading.kinds.tint};
    const AlbedoValues read = read_albedo(shading, k, channels);
    double error = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(layout.size()); ++i)
        error = worse_error(error, std::fabs(read[i] - exact[i]));
    return error;
}

double worse_error(double a, double b) {
    return std::isnan(a) || std::isnan(b) ? limits::infinity : std::max(a, b);
}

TableError summarise(const std::vector<double>& errors) {
    TableError error{.directions = static_cast<int>(errors.size())};
    for (const double e : errors) {
        error.worst = worse_error(error.worst, e);
        error.root_mean_square += e * e / error.directions;
    }
    error.root_mean_square = worse_error(0, std::sqrt(error.root_mean_square));
    return error;
}

}  // namespace nacre
