#include "core/study/slanted_energy.h"

#include "core/bake/bake.h"
#include "core/study/paper_designs.h"

namespace nacre {

Design slanted_white(double mean_cosine_scale, bool clamp) {
    Design design = paper_slanted_velvet(glm::dvec3{0});
    design.distribution.mean_cosine_scale = mean_cosine_scale;
    design.shadowing.clamp = clamp;
    design.fresnel = NoFresnel{};
    design.diffuse = NoDiffuse{};
    return design;
}

AlbedoCheck slanted_energy(double mean_cosine_scale, bool clamp, const std::stop_token& stop) {
    const Design design = slanted_white(mean_cosine_scale, clamp);
    return measure_albedo(*bake(design, {}, stop), Reference(design), stop);
}

}  // namespace nacre
