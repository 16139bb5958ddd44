#include "core/bake/brdf_samples.h"

#include <algorithm>
#include <array>
#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/bake/brdf_samples.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each kind of processor

#include "core/bake/mirror_ways.h"
#include "core/model/lane_columns-inl.h"
#include "core/model/visible_facets.h"

HWY_BEFORE_NAMESPACE();
namespace nacre {
namespace HWY_NAMESPACE {
namespace {

using Lanes = LaneShading<Doubles>;

// rho and pdf of each pair of columns; both directions are above the horizon.
HWY_FLATTEN HWY_ATTR void weigh(const Shading<double>& material, const DirectionColumns& k1,
                                const DirectionColumns& k2, double* const* rho, double* pdf) {
    Lanes shading;
    copy_surface(shading, material);
    const std::size_t width = hn::Lanes(Doubles());
    for (std::size_t i = 0; i < k1.size; i += width) {
        const std::size_t rest = k1.size - i;
        const Lanes::real3 a = load_directions(k1.x + i, k1.y + i, k1.z + i, rest);
        const Lanes::real3 b = load_directions(k2.x + i, k2.y + i, k2.z + i, rest);
        Lanes::real3 value;
        Lanes::real drawn;
        shading.brdf_and_density(direction_of(shading, a), direction_of(shading, b), value, drawn);
        store(value.x, rho[0] + i, rest);
        store(value.y, rho[1] + i, rest);
        store(value.z, rho[2] + i, rest);
        store(drawn, pdf + i, rest);
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace nacre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nacre {
namespace {

HWY_EXPORT(weigh);

constexpr std::size_t at_once = 128;
using Column = std::array<double, at_once>;

// k2 of samples, not above the horizon where there is none.
void draw_some(const Brdf& brdf, std::span<const dvec3> k1, Random& random, std::span<BrdfSample> samples) {
    if (brdf.tables().shading.kinds.coated()) {
        for (std::size_t i = 0; i < k1.size(); ++i) samples[i].k2 = brdf.draw(k1[i], random);
        return;
    }
    const double diffuse = brdf.cosine_probability();
    std::array<dvec3, at_once> from, facets;
    std::array<std::size_t, at_once> index;
    std::array<MirrorWay, at_once> ways;
    std::size_t count = 0;
    for (std::size_t i = 0; i < k1.size(); ++i) {
        samples[i].k2 = dvec3{0};
        if (k1[i].z <= 0) continue;
        if (diffuse > 0 && uniform_random(random) < diffuse) {
            samples[i].k2 = cosine_sample(random);
        } else {
            ways[count] = draw_way(brdf.tables().shading, random);
            from[count] = ways[count].entering(k1[i]);
            index[count++] = i;
        }
    }
    brdf.tables().distribution->visible_facets().draw({from.data(), count}, random, {facets.data(), count});
    for (std::size_t j = 0; j < count; ++j)
        if (facets[j] != dvec3{0}) samples[index[j]].k2 = ways[j].leaving(mirrored(from[j], facets[j]));
}

// Samples below the horizon count as n, seen from n.
void sample_some(const Brdf& brdf, std::span<const dvec3> k1, Random& random, std::span<BrdfSample> samples) {
    draw_some(brdf, k1, random, samples);
    std::array<Column, 10> columns;
    for (std::size_t i = 0; i < k1.size(); ++i) {
        const dvec3 n{0, 0, 1};
        const bool up = samples[i].k2.z > 0;
        samples[i].pdf = up ? 1 : 0;
        if (!up) samples[i].k2 = n;
        const dvec3 from = up ? k1[i] : n;
        for (int c = 0; c < 3; ++c) {
            columns[static_cast<std::size_t>(c)][i] = from[c];
            columns[static_cast<std::size_t>(3 + c)][i] = samples[i].k2[c];
        }
    }
    double* const rho[3] = {columns[6].data(), columns[7].data(), columns[8].data()};
    HWY_DYNAMIC_DISPATCH(weigh)
    (brdf.tables().shading, {columns[0].data(), columns[1].data(), columns[2].data(), k1.size()},
     {columns[3].data(), columns[4].data(), columns[5].data(), k1.size()}, rho, columns[9].data());
    for (std::size_t i = 0; i < k1.size(); ++i) {
        BrdfSample& sample = samples[i];
        const double pdf = columns[9][i];
        if (sample.pdf > 0 && pdf > 0)
            sample = {sample.k2, dvec3{rho[0][i], rho[1][i], rho[2][i]} * (sample.k2.z / pdf), pdf};
        else
            sample = {dvec3{0, 0, 1}, dvec3{0}, 0};
    }
}

}  // namespace

void sample_directions(const Brdf& brdf, std::span<const dvec3> k1, Random& random,
                       std::span<BrdfSample> samples) {
    assert(k1.size() == samples.size());
    for (std::size_t i = 0; i < k1.size(); i += at_once) {
        const std::size_t count = std::min(at_once, k1.size() - i);
        sample_some(brdf, k1.subspan(i, count), random, samples.subspan(i, count));
    }
}

}  // namespace nacre
#endif
