// A fit as a file.
#pragma once

#include <string>
#include <string_view>

#include "core/fit/lobe_fit.h"

namespace nacre {

// docs/fit.md lists the keys.
std::string fit_json(const LobeFit& fit);

std::string_view name_of(LobeShape shape);
std::string_view name_of(LobeWeights weights);
std::string_view name_of(FitTarget target);

}  // namespace nacre
