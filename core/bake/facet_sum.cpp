#include "core/bake/facet_sum.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bake/facet_sum.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include "core/model/lane_shading-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

using Doubles = hn::ScalableTag<double>;
using Lanes = LaneShading<Doubles>;
using Real = Lanes::real;

// The tables are floats and are read as floats, which halves the time: k is exact in double before.
using Floats = hn::Rebind<float, Doubles>;
using Table = LaneShading<Floats>;

struct TableArea {
    HWY_ATTR Real operator()(Lanes::real3 k) const {
        const auto narrow = [](Real x) HWY_ATTR { return Table::real(hn::DemoteTo(Floats(), x.v)); };
        const Table::real3 to(narrow(k.x), narrow(k.y), narrow(k.z));
        return Real(hn::PromoteTo(Doubles(), table.projected_area(to, table.table_spot(to)).v));
    }

    const Table& table;
};

// `count` numbers from `from` on and zeros.
Real load(const double* from, std::size_t count) {
    const Doubles d;
    if (count >= hn::Lanes(d)) return Real(hn::LoadU(d, from));
    HWY_ALIGN double lanes[hn::MaxLanes(d)] = {};
    for (std::size_t i = 0; i < count; ++i) lanes[i] = from[i];
    return Real(hn::Load(d, lanes));
}

HWY_FLATTEN void sum_facets(const Shading<double>& material, const Shading<double>::Direction& from,
                            int channels, const FacetColumns& facets, AlbedoValues& sum) {
    const Doubles d;
    Lanes shading;
    copy_surface(shading, material);
    const Lanes::Direction a{Lanes::real3(from.k), Real(from.g), Lanes::real3(0.0)};
    Table table;
    copy_surface(table, material);
    const TableArea area{table};
    Real sums[4] = {0.0, 0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < facets.size(); i += hn::Lanes(d)) {
        const std::size_t rest = facets.size() - i;
        const Lanes::real3 h(load(facets.x() + i, rest), load(facets.y() + i, rest),
                             load(facets.z() + i, rest));
        const Real mass = load(facets.mass() + i, rest);
        Real values[4];
        shading.facet_albedo(a, h, channels, area, values);
        for (int c = 0; c <= channels; ++c) sums[c] += values[c] * mass;
    }
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = hn::GetLane(hn::SumOfLanes(d, sums[c].v));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(sum_facets);

AlbedoValues sum_albedo(const Shading<double>& shading, dvec3 k1, double g1, int channels,
                        const FacetColumns& facets) {
    AlbedoValues sum{};
    HWY_DYNAMIC_DISPATCH(sum_facets)(shading, {k1, g1, dvec3{0}}, channels, facets, sum);
    return sum;
}

}  // namespace nacre
#endif
