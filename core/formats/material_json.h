// The material of exported tables, for their manifest.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// Each model with its parameters, as their lists have them, and what the bake made of them.
nlohmann::ordered_json material_json(const Design& design, const Tables& tables);

// Whether the specular term has a factor, and whether it is retro-reflective in part.
bool has_intensity(const Design& design);
bool is_retro(const Design& design);

}  // namespace nacre
