// The library for whoever renders: load_design(), bake(), Brdf, evaluate_pairs() and sample_directions(), and
// the UserError that a wrong file is. Where nacre is installed these headers, and what they include, are all
// there is.
#pragma once

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/bake/brdf_pairs.h"
#include "core/bake/brdf_samples.h"
#include "core/base/error.h"
#include "core/design/design_file.h"
