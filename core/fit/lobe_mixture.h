// A few closed lobes that stand for a painted p in another renderer.
#pragma once

#include <vector>

#include "core/fit/lobe_terms.h"

namespace nacre {

// Whose formula the lobes are evaluated by (docs/fit.md). `standard` has lobes about n alone, with constant
// weights: the height-correlated Smith BRDF.
enum class FitTarget { cycles, standard };

enum class LobeWeights { constant, view };

// Angles in degrees. X is along the wider axis: the x axis turned about N by `rotation`.
struct MixtureLobe {
    double weight = 1;
    double alpha_x = 0.5, alpha_y = 0.5;
    double rotation = 0;
    double tilt = 0, azimuth = 0;  // of N
    // With view weights: the weight for a viewing direction v at (vx, vy)/(1 + vz), row by row from y = -1
    // and x = -1, texel centres on the border of [-1, 1]^2; `weight` is in it.
    std::vector<float> tile = {};

    bool operator==(const MixtureLobe&) const = default;
};

inline constexpr int tile_side = 32;

struct LobeMixture {
    LobeShape shape = LobeShape::beckmann;
    LobeWeights weights = LobeWeights::constant;
    std::vector<MixtureLobe> lobes;

    // 1/sr with F = 1, of unit vectors in the local frame; 0 where either is not above the horizon.
    double brdf(glm::dvec3 v, glm::dvec3 l) const;

    bool operator==(const LobeMixture&) const = default;
};

LobeFrame frame_of(const MixtureLobe& lobe);

// Without a tile.
MixtureLobe lobe_of(const LobeFrame& frame);

// The same for many pairs: frames are made once.
class MixtureReader {
  public:
    explicit MixtureReader(const LobeMixture& mixture);  // kept as a reference
    double operator()(glm::dvec3 v, glm::dvec3 l) const;

  private:
    const LobeMixture& mixture_;
    std::vector<LobeFrame> frames_;
};

}  // namespace nacre
