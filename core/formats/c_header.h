// A design as one C99 header, for renderers' own plug-ins.
#pragma once

#include <string>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// C99, and C++ too, that needs <math.h> alone: PREFIX_brdf, PREFIX_sample, PREFIX_pdf and, where R is baked,
// PREFIX_albedo. Every name begins with PREFIX_. It computes in double, or in float where the macro
// PREFIX_FLOAT or NACRE_FLOAT is defined.
std::string c_header(const Design& design, const Tables& tables, const std::string& prefix = "nacre");

}  // namespace nacre
