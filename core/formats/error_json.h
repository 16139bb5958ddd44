// Measured errors as JSON, with the same keys in every file and answer.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/bake/tables.h"

namespace nacre {

// {"worst", "rms", "directions"}
nlohmann::ordered_json error_json(const TableError& error);

// {"g", "R"}, and {"facets"} where they are matt
nlohmann::ordered_json errors_json(const TableErrors& errors);

}  // namespace nacre
