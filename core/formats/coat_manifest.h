// What the manifest of exported tables says of a coat; see shaders/shared/coat.glsl.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/formats/table_files.h"

namespace nacre {

// The formulas: of one direction, then of two.
nlohmann::ordered_json coat_json(const Design& design, const Tables& tables);

// R_c, then u and b.
void add_coat_pictures(const Tables& tables, std::vector<TablePicture>& pictures);

}  // namespace nacre
