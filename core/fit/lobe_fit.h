// A painted p as a few closed lobes for renderers that have no tables (docs/fit.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/bake/tables.h"
#include "core/fit/lobe_mixture.h"

namespace nacre {

inline constexpr int fit_lobes_max = 64;  // closures that a shader of Cycles can have

struct FitSettings {
    FitTarget target = FitTarget::cycles;
    int lobes = 32;  // 1 to fit_lobes_max
    LobeShape shape = LobeShape::beckmann;
    std::optional<LobeWeights> weights = {};  // none: whichever kind comes nearer
    int steps = 1500;                         // of the refinement
    int threads = 0;                          // 0: all of the machine's; the result is the same for any
    std::uint64_t seed = 1;
};

// Part of the energy of the design's specular term (F = 1) that the mixture as it is stored sends elsewhere,
// measured on pairs that the fit did not see: 0 to 2.
struct Misplaced {
    LobeWeights weights;
    double energy;
};

struct LobeFit {
    FitTarget target = FitTarget::cycles;
    LobeMixture mixture;
    double misplaced = 0;
    std::vector<Misplaced> tried;  // each kind of weight that was fitted
};

// `tables` may be of any bake. A UserError where the target lacks what is asked for; BakeCancelled soon after
// a stop is requested. `progress` gets rising values in [0, 1] from the calling thread.
LobeFit fit_lobes(const Tables& tables, const FitSettings& settings, std::stop_token stop = {},
                  const std::function<void(double)>& progress = {});

// What whoever uses the fit should know, a sentence each; none where it is good.
std::vector<std::string> fit_notes(const LobeFit& fit, const Tables& tables);

}  // namespace nacre
