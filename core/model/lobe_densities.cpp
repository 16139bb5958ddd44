#include "core/model/lobe_densities.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/model/lobe_densities.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include "core/model/lane_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

using Lanes = LaneShading<Doubles>;

HWY_FLATTEN HWY_ATTR void densities(const LobeForm& lobe, const DirectionColumns& h, double* p) {
    Lanes shading;
    shading.data = lobe.data;
    Lanes::Layer layer{};
    layer.kind = lobe.kind;
    layer.inverse_width = lobe.inverse_width;
    layer.data_size = lobe.data_size;
    const std::size_t width = hn::Lanes(Doubles());
    for (std::size_t i = 0; i < h.size; i += width) {
        const std::size_t rest = h.size - i;
        const Lanes::real3 at = load_directions(h.x + i, h.y + i, h.z + i, rest);
        store(shading.lobe_density(layer, at), p + i, rest);
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(densities);

void lobe_densities(const LobeForm& lobe, const DirectionColumns& h, double* p) {
    HWY_DYNAMIC_DISPATCH(densities)(lobe, h, p);
}

}  // namespace nacre
#endif
