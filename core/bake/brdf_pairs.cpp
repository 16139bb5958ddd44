#include "core/bake/brdf_pairs.h"

#include <algorithm>
#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bake/brdf_pairs.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include "core/model/lane_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

using Floats = hn::ScalableTag<float>;
using Lanes = LaneShading<Floats>;
using Real = Lanes::real;
using Vector = hn::Vec<Floats>;

Lanes::real3 load(const glm::vec3* from) {
    Vector x, y, z;
    hn::LoadInterleaved3(Floats(), &from->x, x, y, z);
    return {Real(x), Real(y), Real(z)};
}

void store(const Lanes::real3& value, glm::vec3* to) {
    hn::StoreInterleaved3(value.x.v, value.y.v, value.z.v, Floats(), &to->x);
}

// 0 where either is not above the horizon.
HWY_FLATTEN HWY_ATTR HWY_NOINLINE Lanes::real3 brdf(const Lanes& shading, Lanes::real3 k1, Lanes::real3 k2) {
    const Lanes::real3 n(0.0, 0.0, 1.0);
    const auto above = k1.z > Real(0.0) && k2.z > Real(0.0);
    if (none(above)) return Lanes::real3(0.0);
    const Lanes::Direction a = direction_of(shading, select(above, k1, n)),
                           b = direction_of(shading, select(above, k2, n));
    return select(above, shading.coated_brdf_of(a, b), Lanes::real3(0.0));
}

HWY_ATTR void evaluate(const Shading<float>& material, const glm::vec3* k1, const glm::vec3* k2,
                       glm::vec3* rho, std::size_t count) {
    constexpr std::size_t width = hn::MaxLanes(Floats());
    Lanes shading;
    copy_surface(shading, material);
    std::size_t i = 0;
    for (; i + width <= count; i += width) store(brdf(shading, load(k1 + i), load(k2 + i)), rho + i);
    if (i == count) return;
    glm::vec3 a[width]{}, b[width]{}, value[width];
    std::copy(k1 + i, k1 + count, a);
    std::copy(k2 + i, k2 + count, b);
    store(brdf(shading, load(a), load(b)), value);
    std::copy(value, value + (count - i), rho + i);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(evaluate);

void evaluate_pairs(const Shading<float>& shading, std::span<const glm::vec3> k1,
                    std::span<const glm::vec3> k2, std::span<glm::vec3> rho) {
    assert(k1.size() == rho.size() && k2.size() == rho.size());
    HWY_DYNAMIC_DISPATCH(evaluate)(shading, k1.data(), k2.data(), rho.data(), rho.size());
}

}  // namespace nacre
#endif
