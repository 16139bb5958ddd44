// A module for three.js: the design as a material.
#pragma once

#include <string>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// JavaScript that imports "three" and exports material(), tables() and glsl. Ambient light is in it where the
// tables hold R. `file` is its name in the example at its head.
std::string three_js_module(const Design& design, const Tables& tables, const std::string& prefix,
                            const std::string& file);

}  // namespace nacre
