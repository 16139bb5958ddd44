#include "core/study/retro_extremes.h"

#include <fmt/core.h>

#include <utility>

#include "core/study/kind_extremes.h"

namespace nacre {
namespace {

Layer leaning(Lobe lobe, double weight, double tilt, double azimuth) {
    Layer layer;
    layer.lobe = std::move(lobe);
    layer.weight = weight;
    layer.tilt = tilt;
    layer.azimuth = azimuth;
    return layer;
}

// What is seen of it from one side is not seen from the other. A white coupled term takes what is left.
Design lopsided(const Retro& retro, std::vector<Layer> layers) {
    Design design;
    design.distribution.layers = std::move(layers);
    design.diffuse = CoupledDiffuse{glm::dvec3{1}};
    design.retro = retro;
    return design;
}

}  // namespace

void add_retro_extremes(std::vector<ExtremeCase>& cases) {
    for (const auto& [name, retro] : extreme_kinds<std::variant<Retro>>())
        for (std::size_t kind = 0; kind < KindSet<MaskingModel>::count; ++kind) {
            Design design = lopsided(std::get<Retro>(retro), {leaning(GaussianLobe{0.3, 0.3}, 1, 50, 20),
                                                              leaning(GgxLobe{0.05, 0.2}, 0.5, 20, 150)});
            design.shadowing.model = KindSet<MaskingModel>::made(kind);
            const ExtremeClaims claims = tilted_claims(design.shadowing.model, design.shadowing.clamp);
            cases.push_back({"retro",
                             fmt::format("{}, masking {}", name, KindSet<MaskingModel>::names[kind]),
                             design,
                             claims.refusal,
                             {},
                             claims.area,
                             claims.albedo});
        }
    cases.push_back({"retro", "half of a leaning needle",
                     lopsided({0.5}, {leaning(GaussianLobe{1e-3, 1e-3}, 1, 30, 0)})});
}

}  // namespace nacre
