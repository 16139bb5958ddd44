// Tables in a few words for the status line.
#pragma once

#include <string>

#include "core/bake/tables.h"

namespace nacre {

std::string tables_text(const Tables& tables);

}  // namespace nacre
