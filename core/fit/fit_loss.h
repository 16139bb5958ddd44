// How far lobes are from a design's BRDF, with derivatives.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/bake/workers.h"
#include "core/fit/fit_pairs.h"
#include "core/fit/lobe_mixture.h"
#include "core/fit/lobe_parameters.h"
#include "core/fit/view_mask.h"

namespace nacre {

// A lobe whose weight is constant or follows the view. A view weight is the lobe's own weight times
// (N.v) P(v)/(n.v) and times P of the direction that N mirrors v into, blurred by the lobe's width, so that
// the design's masking of v and of the middle of the light it sees are in it.
class ViewedLobe {
  public:
    // `mask` is kept as a pointer.
    ViewedLobe(LobeShape shape, LobeWeights weights, const ViewMask& mask)
        : shape_(shape), weights_(weights), mask_(&mask) {}

    LobeShape shape() const { return shape_; }
    LobeWeights weights() const { return weights_; }

    // The BRDF of one lobe of weight 1, 1/sr.
    double unit_value(const LobeFrame& lobe, const FitPair& pair) const;

    // The view weight; `part` is P(v)/(n.v).
    double view_weight(const LobeFrame& lobe, dvec3 v, double part) const;

    // The lobe's BRDF, and its derivatives added; nothing where it sends no light from l into v.
    std::optional<double> value(const LobeFrame& lobe, const FitPair& pair, FrameGradient& gradient) const;

  private:
    MaskValue mirrored_mask(const LobeFrame& lobe, dvec3 v) const;

    LobeShape shape_;
    LobeWeights weights_;
    const ViewMask* mask_;
};

struct Loss {
    double value = 0;  // a smoothed sum of |difference| over that of rho
    std::vector<LobeParameters> gradient;
};

// Over the pairs of these indices; the same to the last bit for any number of threads.
Loss fit_loss(const ViewedLobe& model, std::span<const LobeParameters> lobes, std::span<const FitPair> pairs,
              std::span<const std::size_t> indices, Workers& workers);

// Part of the energy that the lobes misplace.
double misplaced_energy(const ViewedLobe& model, std::span<const LobeFrame> lobes,
                        std::span<const FitPair> pairs);
double misplaced_energy(const LobeMixture& mixture, std::span<const FitPair> pairs);

}  // namespace nacre
