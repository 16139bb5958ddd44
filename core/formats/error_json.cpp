#include "core/formats/error_json.h"

#include <nlohmann/json.hpp>

namespace nacre {

nlohmann::ordered_json error_json(const TableError& error) {
    return {{"worst", error.worst}, {"rms", error.root_mean_square}, {"directions", error.directions}};
}

nlohmann::ordered_json errors_json(const TableErrors& errors) {
    nlohmann::ordered_json json = {{"g", error_json(errors.area)}, {"R", error_json(errors.albedo)}};
    if (errors.facets.directions > 0) json["facets"] = error_json(errors.facets);
    return json;
}

}  // namespace nacre
