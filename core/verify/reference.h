// The reference: adaptive integration in double, in the lobes' own coordinates, without tables.
#pragma once

#include <stop_token>

#include "core/bake/albedo.h"
#include "core/design/design.h"
#include "core/model/facet_distribution.h"
#include "core/model/shading.h"
#include "core/verify/adaptive_albedo.h"

namespace nacre {

class Reference {
  public:
    // Throws UserError like bake().
    explicit Reference(const Design& design);
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

    // g and P = N c/g (min(1, .) under clamp), relative error below 1e-9. Where a picture takes part g is
    // within 5e-6 of p's own, which is bilinear between texels, relative to the whole; 2e-5 where each texel
    // of a modulation differs from the next as much as it can.
    double projected_area(dvec3 k) const { return distribution_.projected_area(k); }
    double visibility(dvec3 k) const;

    // R with F = 1, then with Schlick's weight (f0 = 0), or with the design's exact F in three colours; see
    // AlbedoLayout. Absolute error below 1e-6; 2e-5 where a picture takes part, also one of a single texel.
    AlbedoValues albedo(dvec3 k, std::stop_token stop = {}) const;

    // The design's own R, one value a colour.
    dvec3 design_albedo(const AlbedoValues& values) const;

    // Walks that the part of bounces in what a diffuse term leaves out comes from, a direction.
    void set_walks(int walks) { walks_ = walks; }

    // The BRDF, 1/sr, without its multiple bounces (bounce_oracle.h). The constant c of eq. 28 is 0 until
    // prepare_coupling().
    Shading<double>::Direction direction(dvec3 k, std::stop_token stop = {}) const;
    const Shading<double>& shading() const { return shading_; }

    // c of eq. 28 from exact R on a Gauss rule over the hemisphere, relative error about 1e-4 for one smooth
    // lobe. Costs some hundred albedos; does nothing where no diffuse term reads R.
    void prepare_coupling(std::stop_token stop = {});

    const FacetDistribution& distribution() const { return distribution_; }
    const Distribution& layers() const { return layers_; }  // of the design
    int channels() const { return channels_; }              // of albedo(), F = 1 apart
    AlbedoLayout layout() const { return {channels_, shading_.kinds.tint}; }

  private:
    Distribution layers_;
    FacetDistribution distribution_;
    AdaptiveAlbedo albedo_;
    Shading<double> shading_;
    std::vector<float> data_;
    int channels_;
    bool round_;
    bool reads_albedo_;
    bool bounces_;
    int walks_ = 16384;
    bool same_turned_;  // half a turn about n leaves p as it is
};

}  // namespace nacre
