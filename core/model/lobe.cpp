#include "core/model/lobe.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/model/lobe_envelope.h"
#include "core/model/picture_lobe.h"

namespace nacre {
void LobeModel::densities(const DirectionColumns& h, double* p) const {
    for (std::size_t i = 0; i < h.size; ++i) p[i] = density({h.x[i], h.y[i], h.z[i]});
}

dvec3 LobeModel::mean() const {
    dvec3 sum{0};
    for (int i = 0; i < 3; ++i) {
        dvec3 k{0};
        k[i] = 1;
        sum[i] = projected_area(k) - projected_area(-k);
    }
    return sum;
}

std::vector<Facet> LobeModel::facets(std::size_t) const { return {}; }

std::unique_ptr<const LobeEnvelope> LobeModel::envelope() const { return nullptr; }

void LobeModel::visit_points(const std::function<void(const Facet&)>&) const {}

std::shared_ptr<const LobeModel> make_lobe(const Layer& layer, Fineness fineness) {
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.modulated_model(layer.modulation, fineness); }) {
                return kind.modulated_model(layer.modulation, fineness);
            } else {
                std::shared_ptr<const LobeModel> lobe = kind.model();
                if (layer.modulation)
                    lobe = make_modulated_lobe(std::move(lobe), *layer.modulation, fineness);
                return lobe;
            }
        },
        layer.lobe);
}

double uniform_random(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

dvec3 cosine_sample(Random& random) {
    const double radius = std::sqrt(uniform_random(random));
    const double phi = 2 * std::numbers::pi * uniform_random(random);
    return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1 - radius * radius)};
}

double cosine_density(dvec3 k) { return k.z / std::numbers::pi; }

}  // namespace nacre
