#include "core/study/coat_extremes.h"

#include "core/study/kind_extremes.h"

namespace nacre {

// Over a metal that leans and loses nothing to its own bounces, and over a needle beneath which all is white.
void add_coat_extremes(std::vector<ExtremeCase>& cases) {
    Design metal;
    metal.distribution.layers[0].lobe = GgxLobe{0.1, 0.4};
    metal.distribution.layers[0].tilt = 20;
    metal.fresnel = NoFresnel{};
    metal.multibounce = RankOneMultibounce{};
    Design needle;
    needle.distribution.layers[0].lobe = GaussianLobe{1e-3, 1e-3};
    needle.diffuse = CoupledDiffuse{glm::dvec3{1}};
    for (const auto& [name, coat] : extreme_kinds<Coat>()) {
        if (!is_coated(coat)) continue;
        metal.coat = needle.coat = coat;
        cases.push_back({"coat", name + ", leaning metal", metal});
        cases.push_back({"coat", name + ", white needle", needle});
    }
}

}  // namespace nacre
