// p of a design as the manifest of exported tables states it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

nlohmann::ordered_json distribution_json(const Design& design, const Tables& tables);

}  // namespace nacre
