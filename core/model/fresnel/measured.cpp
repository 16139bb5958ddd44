#include "core/model/fresnel/measured.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/model/fresnel/f82.h"
#include "core/model/spectral/fresnel_curve.h"
#include "core/model/spectral/spectral_colour.h"
#include "core/model/spectral/thin_film.h"

namespace nacre {
namespace {

using glm::dvec3;

// What tells two materials apart: straight on and before grazing.
struct Seen {
    dvec3 normal, edge;
};

Seen seen(const Reflectance& f) { return {f(1), f(F82Fresnel::cosine82)}; }

double difference(const Seen& a, const Seen& b) {
    const dvec3 normal = a.normal - b.normal, edge = a.edge - b.edge;
    return glm::dot(normal, normal) + glm::dot(edge, edge);
}

const std::vector<Seen>& seen_materials() {
    static const std::vector<Seen> all = [] {
        std::vector<Seen> list;
        for (std::size_t i = 0; i < material_names.size(); ++i)
            list.push_back(seen(MeasuredFresnel{static_cast<Material>(i)}.reflectance()));
        return list;
    }();
    return all;
}

}  // namespace

Reflectance MeasuredFresnel::reflectance(double above) const {
    return [material = material, above, nodes = spectral_nodes(1)](double cosine) {
        dvec3 colour{0};
        for (const SpectralNode& node : nodes)
            colour += node.weight * film_reflectance({}, index_at(material, node.wavelength), node.wavelength,
                                                     cosine, above);
        return colour;
    };
}

ShaderFresnel MeasuredFresnel::shader(double above) const {
    static CurveMemory<MeasuredFresnel> memory;
    return {.curve = memory.curve_of(*this, above)};
}

MeasuredFresnel MeasuredFresnel::of_reflectance(const Reflectance& wanted) {
    const Seen colour = seen(wanted);
    const auto& all = seen_materials();
    const auto nearest = std::min_element(all.begin(), all.end(), [&](const Seen& a, const Seen& b) {
        return difference(a, colour) < difference(b, colour);
    });
    return {static_cast<Material>(nearest - all.begin())};
}

dvec3 MeasuredFresnel::material_colour(std::size_t index) {
    return clip_to_gamut(seen_materials().at(index).normal).colour;
}

}  // namespace nacre
