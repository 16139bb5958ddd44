#include "core/verify/reference.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/bake/needs.h"
#include "core/bake/stretched_grid.h"
#include "core/bake/table_size.h"
#include "core/shading/surface.h"
#include "core/verify/bounce_oracle.h"

namespace nacre {
namespace {

using std::numbers::pi;

// What both rules of an adaptive pair agree on may still hide a kink that no cut is made at: where P1 = P2,
// which the correlated models have. Asked for more, they find it.
double albedo_tolerance(const Design& design) {
    return masking_bends(design.shadowing.model.index()) == MaskingBends::none ? 5e-7 : 1e-8;
}

}  // namespace

Reference::Reference(const Design& design)
    : layers_(design.distribution),
      distribution_(layers_,
                    [](const Layer& layer, std::size_t) { return make_lobe(layer, Fineness::exact); }),
      albedo_(distribution_, albedo_tolerance(design)) {
    describe_material(design, distribution_, shading_);
    describe_layers(design.distribution, distribution_, shading_, data_);
    shading_.data = data_.data();
    const Needs needs = needs_of(design, {.albedo = true});
    if (shading_.kinds.masking_bends() == MaskingBends::azimuth)
        shading_.surface.tables.axis =
            StretchedGrid(distribution_, needs.symmetry,
                          first_size(needs.symmetry.symmetry, Quality::final).psi, false)
                .shape()
                .axis;
    channels_ = needs.fresnel_tables;
    round_ = needs.symmetry.symmetry == Symmetry::isotropic;
    same_turned_ = round_ || needs.symmetry.symmetry == Symmetry::quarter;
    reads_albedo_ = nacre::reads_albedo(design.diffuse);
    bounces_ = has_bounces(design.multibounce);
    shading_.kinds.albedo = reads_albedo_;
}

double Reference::visibility(dvec3 k) const {
    const double g = projected_area(k);
    const double nc = shading_.surface.N * k.z;
    const double p = g > 0 ? nc / g : 0;
    return shading_.kinds.clamp ? std::min(p, 1.0) : p;
}

AlbedoValues Reference::albedo(dvec3 k, std::stop_token stop) const {
    if (shading_.kinds.masking_bends() == MaskingBends::azimuth)
        k = beside_normal(k, shading_.surface.tables.axis);
    return albedo_(
        {shading_, k, projected_area(k), channels_}, [&](dvec3 k2) { return projected_area(k2); }, stop);
}

dvec3 Reference::design_albedo(const AlbedoValues& values) const {
    const AlbedoLayout layout = this->layout();
    dvec3 full{0}, with_factor{0};
    for (int c = 0; c < 3; ++c) {
        full[c] = values[static_cast<std::size_t>(c % layout.full())];
        if (channels_ > 0)
            with_factor[c] = values[static_cast<std::size_t>(layout.full() + c % layout.factors())];
    }
    const dvec3 f0 = shading_.surface.fresnel_a;
    const dvec3 R = channels_ == 0   ? full
                    : channels_ == 3 ? with_factor
                                     : f0 * full + (1.0 - f0) * with_factor;
    return layout.tint == Tint::shared ? R * shading_.layers[0].tint : R;
}

Shading<double>::Direction Reference::direction(dvec3 k, std::stop_token stop) const {
    const auto R = [&](dvec3 of) { return reads_albedo_ ? design_albedo(albedo(of, stop)) : dvec3{0}; };
    auto a = Shading<double>::known_direction(k, projected_area(k), R(k));
    if (reads_albedo_ && bounces_) a.M = BounceOracle(*this).albedo(k, {.walks = walks_}, stop).mean;
    if (!shading_.kinds.retro) return a;
    const dvec3 turned = shading_.turned(k);
    a.turned_g = same_turned_ ? a.g : projected_area(turned);
    a.retro_R = 0.5 * (a.R + (same_turned_ ? a.R : R(turned)));
    a.R = shading_.retro_mixed(a.R, a.retro_R);
    return a;
}

// Gauss-Legendre over theta, whose cosine weight hides the band near grazing where R turns, and the
// trapezoidal rule over azimuth.
void Reference::prepare_coupling(std::stop_token stop) {
    if (!reads_albedo_) return;
    const auto& rule = gauss_legendre<10>();
    const int polar = static_cast<int>(rule.size());
    const int azimuths = round_ ? 1 : 24;
    std::vector<dvec3> parts(static_cast<std::size_t>(polar * azimuths));
    tbb::parallel_for(0, polar * azimuths, [&](int i) {
        const QuadraturePoint& node = rule[static_cast<std::size_t>(i % polar)];
        const double phi = 2 * pi * (i / polar + 0.5) / azimuths;
        const double theta = 0.5 * pi * node.x;
        const double sine = std::sin(theta), cosine = std::cos(theta);
        const auto spot = direction({sine * std::cos(phi), sine * std::sin(phi), cosine}, stop);
        parts[static_cast<std::size_t>(i)] =
            shading_.diffuse_share(spot) * (0.5 * pi * node.weight * sine * cosine * 2 * pi / azimuths);
    });
    dvec3 sum{0};
    for (const dvec3& part : parts) sum += part;
    for (int i = 0; i < 3; ++i) shading_.surface.coupling[i] = sum[i] > 1e-9 ? 1 / sum[i] : 0;
}

}  // namespace nacre
