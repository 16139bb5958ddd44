#include "core/bake/direction_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bake/direction_sums.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include "core/model/lane_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

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

// values(direction, out) of every direction times its weight. Past the end weights are 0.
template <std::size_t Size, class ValuesAt>
HWY_FLATTEN HWY_ATTR void weigh(const WeightedDirections& directions, const ValuesAt& values_at,
                                Values<Size>& sum) {
    const Doubles d;
    Real sums[Size];
    for (Real& zero : sums) zero = Real(0.0);
    for (std::size_t i = 0; i < directions.size(); i += hn::Lanes(d)) {
        const std::size_t rest = directions.size() - i;
        const Lanes::real3 h =
            load_directions(directions.x() + i, directions.y() + i, directions.z() + i, rest);
        const Real weight = load(directions.weight() + i, rest);
        Real values[Size];
        values_at(h, values);
        for (std::size_t c = 0; c < Size; ++c) sums[c] += values[c] * weight;
    }
    for (std::size_t c = 0; c < Size; ++c) sum[c] = hn::GetLane(hn::SumOfLanes(d, sums[c].v));
}

void sum_over_facets(const Shading<double>& material, const Shading<double>::Direction& from, int channels,
                     const WeightedDirections& facets, FirstBounce which, LayerAlbedo& sum) {
    Lanes shading;
    copy_surface(shading, material);
    Table table;
    copy_surface(table, material);
    const Lanes::Direction a = Lanes::known_direction(Lanes::real3(from.k), Real(from.g), Lanes::real3(0.0));
    const TableArea area{table};
    const auto leaves = [&](Lanes::real3 h, Real(&values)[4])
                            HWY_ATTR { shading.facet_albedo(a, h, channels, area, values); };
    const auto stays = [&](Lanes::real3 h, Real(&values)[4])
                           HWY_ATTR { shading.facet_bounce(a, h, channels, area, values); };
    which == FirstBounce::leaves ? weigh(facets, leaves, sum) : weigh(facets, stays, sum);
}

void sum_over_shares(const Shading<double>& material, const WeightedDirections& directions, Values<6>& sum) {
    Lanes shading;
    copy_surface(shading, material);
    weigh(
        directions,
        [&](Lanes::real3 k, Real(&values)[6]) HWY_ATTR {
            const Lanes::Direction a = shading.direction(k);
            const Lanes::real3 full =
                shading.colour_albedo_f1(shading.albedo_spot(k, shading.table_spot(k))) *
                shading.clamped_part(k, a.g);
            const Lanes::real3 share = shading.diffuse_share(a);
            values[0] = full.x;
            values[1] = full.y;
            values[2] = full.z;
            values[3] = share.x;
            values[4] = share.y;
            values[5] = share.z;
        },
        sum);
}

void sum_over_rests(const Shading<double>& material, const WeightedDirections& directions, Values<4>& sum) {
    Lanes shading;
    copy_surface(shading, material);
    weigh(
        directions,
        [&](Lanes::real3 k, Real(&values)[4]) HWY_ATTR {
            const Lanes::TableSpot spot = shading.table_spot(k);
            const Real g = shading.projected_area(k, spot);
            const Lanes::Direction a =
                shading.with_bounces(Lanes::known_direction(k, g, Lanes::real3(0.0)),
                                     shading.albedo_spot(k, spot), shading.clamped_part(k, g));
            values[0] = a.rest;
            values[1] = a.rest * a.bounce_F.x;
            values[2] = a.rest * a.bounce_F.y;
            values[3] = a.rest * a.bounce_F.z;
        },
        sum);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {

HWY_EXPORT(sum_over_facets);
HWY_EXPORT(sum_over_shares);
HWY_EXPORT(sum_over_rests);

LayerAlbedo sum_albedo(const Shading<double>& shading, dvec3 k1, double g1, int channels,
                       const WeightedDirections& facets, FirstBounce which) {
    LayerAlbedo sum{};
    HWY_DYNAMIC_DISPATCH(sum_over_facets)
    (shading, Shading<double>::known_direction(k1, g1, dvec3{0}), channels, facets, which, sum);
    return sum;
}

Values<6> sum_shares(const Shading<double>& shading, const WeightedDirections& directions) {
    Values<6> sum{};
    HWY_DYNAMIC_DISPATCH(sum_over_shares)(shading, directions, sum);
    return sum;
}

Values<4> sum_rests(const Shading<double>& shading, const WeightedDirections& directions) {
    Values<4> sum{};
    HWY_DYNAMIC_DISPATCH(sum_over_rests)(shading, directions, sum);
    return sum;
}

}  // namespace nacre
#endif
