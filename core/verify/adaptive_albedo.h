// R(k) by adaptive integration in the lobes' own coordinates.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <stop_token>
#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/verify/picture_rule.h"

namespace nacre {

class AdaptiveAlbedo {
  public:
    // `tolerance`: absolute, of every value. A lobe that has no smooth form is summed over at most
    // this many of its cells; with 0 it is integrated as its picture is.
    AdaptiveAlbedo(const FacetDistribution& distribution, double tolerance, std::size_t facets = 0)
        : distribution_(distribution), tolerance_(tolerance), facet_count_(facets) {
        for (const PlacedLobe& placed : distribution.lobes())
            rules_.push_back(facets == 0 && placed.lobe->spans().empty()
                                 ? std::make_unique<const PictureRule>(placed)
                                 : nullptr);
    }

    // `integrand` holds k1 and in its shading the lobes' tints; area(k2) is g. Throws BakeCancelled soon
    // after a stop is requested.
    template <class AreaOf>
    AlbedoValues operator()(const FacetAlbedo& integrand, const AreaOf& area,
                            const std::stop_token& stop) const {
        const AlbedoLayout layout{integrand.channels, integrand.shading.kinds.tint};
        AlbedoValues sum{};
        for (std::size_t i = 0; i < rules_.size(); ++i) {
            const PlacedLobe& placed = distribution_.lobes()[i];
            const dvec3 tint = integrand.shading.layers[i].tint;
            layout.add(rules_[i] ? over_picture(*rules_[i], integrand, area, stop)
                                 : over_facets(placed, integrand, area, stop),
                       tint, sum);
            for (const LobeParameterization& span : placed.lobe->spans()) {
                const GreatCircleQuadrature walk(placed, span, integrand.k1);
                const std::vector<double> cuts = walk.azimuth_cuts(integrand.shading.kinds.masking_bends());
                for (std::size_t part = 0; part + 1 < cuts.size(); ++part)
                    layout.add(
                        integrate_adaptively<4>(
                            [&](double psi) { return over_chi(integrand, area, walk, psi, stop); },
                            walk.start() + cuts[part] * std::numbers::pi,
                            walk.start() + cuts[part + 1] * std::numbers::pi, tolerance_, depth_azimuth),
                        tint, sum);
            }
        }
        return sum;
    }

  private:
    static constexpr int depth_azimuth = 20, depth_polar = 12;
    // Of a lobe that holds a picture, whose g is not known closer: the tolerance in others', and the least.
    static constexpr double picture_part = 10, picture_min = 5e-6;

    static void add(LayerAlbedo& sum, const LayerAlbedo& values, double weight) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * values[i];
    }

    template <class AreaOf>
    LayerAlbedo over_picture(const PictureRule& rule, const FacetAlbedo& integrand, const AreaOf& area,
                             const std::stop_token& stop) const {
        return rule.integrate([&](dvec3 h) { return integrand(h, area); },
                              std::fmax(picture_part * tolerance_, picture_min), stop);
    }

    // Nothing of a lobe that has a smooth form.
    template <class AreaOf>
    LayerAlbedo over_facets(const PlacedLobe& placed, const FacetAlbedo& integrand, const AreaOf& area,
                            const std::stop_token& stop) const {
        LayerAlbedo sum{};
        if (!placed.lobe->spans().empty()) return sum;
        for (const Facet& facet : placed.lobe->facets(facet_count_)) {
            if (stop.stop_requested()) throw BakeCancelled();
            add(sum, integrand(placed.frame * facet.h, area), placed.scale * facet.mass);
        }
        return sum;
    }

    template <class AreaOf>
    LayerAlbedo over_chi(const FacetAlbedo& integrand, const AreaOf& area, const GreatCircleQuadrature& walk,
                         double psi, const std::stop_token& stop) const {
        const GreatCircleQuadrature::Ray whole = walk.ray(psi);
        std::vector<double> cuts;
        walk.cuts(whole, integrand.shading.kinds.masking_bends(), cuts);
        auto at = [&](double chi) {
            if (stop.stop_requested()) throw BakeCancelled();
            const Facet facet = walk.facet(whole, chi);
            LayerAlbedo values{};
            if (facet.mass > 0) add(values, integrand(facet.h, area), facet.mass);
            return values;
        };
        LayerAlbedo sum{};
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (cuts[i + 1] > cuts[i])
                add(sum, integrate_adaptively<4>(at, cuts[i], cuts[i + 1], 0.5 * tolerance_, depth_polar), 1);
        return sum;
    }

    const FacetDistribution& distribution_;
    double tolerance_;
    std::size_t facet_count_;
    std::vector<std::unique_ptr<const PictureRule>> rules_;  // of the lobes that hold a picture
};

}  // namespace nacre
