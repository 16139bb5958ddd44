// R(k) by adaptive integration in the lobes' own coordinates.
#pragma once

#include <memory>
#include <numbers>
#include <stop_token>
#include <vector>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/measure/picture_rule.h"

namespace nacre {

class AdaptiveAlbedo {
  public:
    // `tolerance`: absolute, of every value.
    AdaptiveAlbedo(const FacetDistribution& distribution, double tolerance)
        : distribution_(distribution), tolerance_(tolerance) {
        for (const PlacedLobe& placed : distribution.lobes())
            rules_.push_back(placed.lobe->spans().empty() ? std::make_unique<const PictureRule>(placed)
                                                          : nullptr);
    }

    // `integrand` holds k1; area(k2) is g. Throws BakeCancelled soon after a stop is requested.
    template <class AreaOf>
    AlbedoValues operator()(const FacetAlbedo& integrand, const AreaOf& area,
                            const std::stop_token& stop) const {
        AlbedoValues sum{};
        for (std::size_t i = 0; i < rules_.size(); ++i) {
            const PlacedLobe& placed = distribution_.lobes()[i];
            if (rules_[i])
                add(sum,
                    rules_[i]->integrate([&](dvec3 h) { return integrand(h, area); },
                                         picture_part * tolerance_, stop),
                    1);
            for (const LobeSpan& span : placed.lobe->spans()) {
                const LobeWalk walk(placed, span, integrand.k1);
                for (int half = 0; half < 2; ++half)
                    add(sum,
                        integrate_adaptively<4>(
                            [&](double psi) { return over_chi(integrand, area, walk, psi, stop); },
                            walk.start() + half * std::numbers::pi,
                            walk.start() + (half + 1) * std::numbers::pi, tolerance_, depth_azimuth),
                        1);
            }
        }
        return sum;
    }

  private:
    static constexpr double picture_part = 10;  // the tolerance of a lobe that holds a picture, in others'
    static constexpr int depth_azimuth = 20, depth_polar = 12;

    static void add(AlbedoValues& sum, const AlbedoValues& values, double weight) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * values[i];
    }

    template <class AreaOf>
    AlbedoValues over_chi(const FacetAlbedo& integrand, const AreaOf& area, const LobeWalk& walk, double psi,
                          const std::stop_token& stop) const {
        const LobeWalk::Ray whole = walk.ray(psi);
        std::vector<double> cuts = {whole.begin};
        for (const double b : walk.breaks())
            if (b > whole.begin && b < whole.end) cuts.push_back(b);
        cuts.push_back(whole.end);
        auto at = [&](double chi) {
            if (stop.stop_requested()) throw BakeCancelled();
            const Facet facet = walk.facet(whole, chi);
            AlbedoValues values{};
            if (facet.mass > 0) add(values, integrand(facet.h, area), facet.mass);
            return values;
        };
        AlbedoValues sum{};
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (cuts[i + 1] > cuts[i])
                add(sum, integrate_adaptively<4>(at, cuts[i], cuts[i + 1], 0.5 * tolerance_, depth_polar), 1);
        return sum;
    }

    const FacetDistribution& distribution_;
    double tolerance_;
    std::vector<std::unique_ptr<const PictureRule>> rules_;  // of the lobes that hold a picture
};

}  // namespace nacre
