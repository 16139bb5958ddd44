// Is an extreme design's BRDF finite and non-negative, and as close to the reference as its bake claims?
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/extremes.h"
#include "core/study/plain_method.h"
#include "core/verify/albedo_check.h"
#include "core/verify/table_error.h"

namespace nacre {

// How many directions a case is judged on.
struct ExtremeOptions {
    int pairs = 2000;  // beside those of the edges: c = 0, 1e-6 and less, k1 = k2, k1 = -k2 along the surface
    ProbeCounts probes = {.area = 200, .albedo = 4};
    AlbedoRings rings = {.polar = 4, .azimuths = 5};
    bool plain_method = true;
};

// An error on directions that are not the bake's own, and allowed_error().
struct ClaimedError {
    double error = 0;
    double bound = 0;
};

struct ExtremeResult {
    std::string refusal = {};              // what the bake said; empty: it made tables
    std::vector<std::string> faults = {};  // what does not hold
    ClaimedError area = {};                // of g, as in area_error()
    ClaimedError albedo = {};              // of R
    double largest_albedo = 0;             // R with F = 1
    int pairs = 0;
    PlainMethodErrors plain = {};
    double seconds = 0;

    bool holds() const { return faults.empty(); }
};

// Bakes the case with R and judges it. Throws BakeCancelled soon after a stop is requested.
ExtremeResult judge(const ExtremeCase& extreme, const ExtremeOptions& options = {},
                    const std::stop_token& stop = {});

// Judges the tables of a case: every rho finite, non-negative and exactly reciprocal, in double and
// in float; R at most 1 under clamp; the errors of g and R as claimed; rho that of `same_rho`.
ExtremeResult judge_tables(const ExtremeCase& extreme, const std::shared_ptr<const Tables>& tables,
                           const ExtremeOptions& options = {}, std::stop_token stop = {});

// All of them, several at a time. `progress` gets rising values in [0, 1], from one thread at a time.
std::vector<ExtremeResult> judge_all(std::span<const ExtremeCase> cases, const ExtremeOptions& options = {},
                                     std::stop_token stop = {},
                                     const std::function<void(double)>& progress = {});

}  // namespace nacre
