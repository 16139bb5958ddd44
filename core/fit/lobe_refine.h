// Makes a first mixture the nearest to the design's BRDF.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/fit/fit_loss.h"

namespace nacre {

// The weights, from 0 to weight_max, that come nearest in squares, each pair weighed so that the sum of
// squares is about one of |difference|.
void reweigh(const ViewedLobe& model, std::span<const FitPair> pairs, std::vector<LobeFrame>& lobes,
             Workers& workers);

struct RefineSettings {
    int steps = 1500;
    int batch = 1500;    // pairs of a step
    bool tilted = true;  // else normals stay where they are
    std::uint64_t seed = 1;
};

// Adam (Kingma & Ba 2015) on fit_loss(). `progress` gets the part that is done.
std::vector<LobeFrame> refine(const ViewedLobe& model, std::span<const FitPair> pairs,
                              const std::vector<LobeFrame>& start, const RefineSettings& settings,
                              Workers& workers, const std::function<void(double)>& progress);

}  // namespace nacre
