// How readers evaluate the tables (Mitsuba 3's and pbrt-v4's `measured`).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/formats/rgl_place.h"
#include "core/formats/rgl_tables.h"

namespace nacre {
namespace {

using std::numbers::pi;

struct Place {
    std::size_t index;  // of the node before
    double part;        // 0 to 1 toward the next
};

// In rising numbers; beyond their ends the outermost.
Place place_in(const std::vector<double>& nodes, double at) {
    if (nodes.size() < 2) return {0, 0};
    const auto next = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, at);
    const std::size_t index = static_cast<std::size_t>(next - nodes.begin()) - 1;
    return {index, std::clamp((at - nodes[index]) / (nodes[index + 1] - nodes[index]), 0.0, 1.0)};
}

Place place_among(int nodes, double at) {
    const double place = std::clamp(at, 0.0, 1.0) * (nodes - 1);
    const int index = std::min(static_cast<int>(place), nodes - 2);
    return {static_cast<std::size_t>(index), place - index};
}

// Bilinear in rows of `columns`.
template <class T>
auto between(const T* values, int columns, int rows, dvec2 at) {
    const Place x = place_among(columns, at.x), y = place_among(rows, at.y);
    const T* first = values + y.index * static_cast<std::size_t>(columns) + x.index;
    const T* second = first + columns;
    using Number = std::conditional_t<std::is_same_v<T, float>, double, dvec3>;
    return (Number(first[0]) * (1 - x.part) + Number(first[1]) * x.part) * (1 - y.part) +
           (Number(second[0]) * (1 - x.part) + Number(second[1]) * x.part) * y.part;
}

}  // namespace

double RglTables::sigma_at(dvec3 wi) const {
    return between(sigma.data(), size.areas.x, size.areas.y, rgl_place(wi));
}

dvec3 RglTables::evaluate(dvec3 wi, dvec3 wo) const {
    const dvec3 m = glm::normalize(wi + wo);
    const double turned = isotropic() ? azimuth_of(wi) : 0;
    const dvec2 at = rgl_place(m, turned);
    const Place t = place_in(theta, elevation_of(wi)), p = place_in(phi, azimuth_of(wi));
    std::vector<MixedDensity::Part> parts;
    std::vector<std::size_t> incident;
    for (int i = 0; i < 4; ++i) {
        const double weight = (i % 2 == 0 ? 1 - t.part : t.part) * (i / 2 == 0 ? 1 - p.part : p.part);
        if (!(weight > 0)) continue;
        incident.push_back((p.index + static_cast<std::size_t>(i / 2)) * theta.size() + t.index +
                           static_cast<std::size_t>(i % 2));
        parts.push_back({&warp[incident.back()], weight});
    }
    const dvec2 uniform = MixedDensity(parts).uniform(at);
    dvec3 value(0);
    for (std::size_t i = 0; i < parts.size(); ++i)
        value +=
            parts[i].weight * between(&values[values_of(incident[i])], size.values.x, size.values.y, uniform);
    const double normals = between(ndf.data(), size.normals.x, size.normals.y, at);
    return value * (normals / (4 * sigma_at(wi)));
}

}  // namespace nacre
