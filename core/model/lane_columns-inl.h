// Numbers of a column into a vector and back, for files that Highway compiles once for each kind of
// processor.
#if defined(NACRE_LANE_COLUMNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NACRE_LANE_COLUMNS_INL_H
#undef NACRE_LANE_COLUMNS_INL_H
#else
#define NACRE_LANE_COLUMNS_INL_H
#endif

#include <algorithm>

#include "core/model/lane_shading-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {

using Doubles = hn::ScalableTag<double>;

// The first `count` lanes from `from` on, and zeros.
HWY_ATTR inline LaneReals<Doubles> load(const double* from, std::size_t count) {
    const Doubles d;
    if (count >= hn::Lanes(d)) return LaneReals<Doubles>(hn::LoadU(d, from));
    HWY_ALIGN double lanes[hn::MaxLanes(d)] = {};
    std::copy_n(from, count, lanes);
    return LaneReals<Doubles>(hn::Load(d, lanes));
}

// The first `count` directions, and n past the end.
HWY_ATTR inline LaneReals3<Doubles> load_directions(const double* x, const double* y, const double* z,
                                                    std::size_t count) {
    LaneReals3<Doubles> k(load(x, count), load(y, count), load(z, count));
    const Doubles d;
    if (count < hn::Lanes(d))
        k.z = select(LaneMask<Doubles>{hn::FirstN(d, count)}, k.z, LaneReals<Doubles>(1.0));
    return k;
}

// The first `count` lanes.
HWY_ATTR inline void store(LaneReals<Doubles> value, double* to, std::size_t count) {
    const Doubles d;
    if (count >= hn::Lanes(d)) {
        hn::StoreU(value.v, d, to);
        return;
    }
    HWY_ALIGN double lanes[hn::MaxLanes(d)];
    hn::Store(value.v, d, lanes);
    std::copy_n(lanes, count, to);
}

// Compiled once, although both ends of a pair need it: everything is inlined into what loops over pairs.
template <class Lanes>
HWY_FLATTEN HWY_ATTR HWY_NOINLINE typename Lanes::Direction direction_of(const Lanes& shading,
                                                                         typename Lanes::real3 k) {
    return shading.direction(k);
}

}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#endif
