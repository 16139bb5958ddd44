// What one part of a design costs: evaluation and bake with it against those without.
#pragma once

#include <string>

#include "core/bake/bake.h"
#include "tests/bench/subjects.h"

namespace nacre::bench {

// BRDFs of 4,096 pairs of directions, at most `times` as long.
void add_evaluation_cost(Report& report, const std::string& what, const Design& with, const Design& without,
                         double times);

// Processor time that it adds to the bake, seconds.
void add_bake_cost(Report& report, const std::string& what, const Design& with, const Design& without,
                   Quality quality, double wanted);

}  // namespace nacre::bench
