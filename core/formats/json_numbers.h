// Vectors as JSON arrays.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace nacre {

inline nlohmann::ordered_json json_numbers(glm::dvec2 v) { return nlohmann::ordered_json::array({v.x, v.y}); }
inline nlohmann::ordered_json json_numbers(glm::dvec3 v) {
    return nlohmann::ordered_json::array({v.x, v.y, v.z});
}

}  // namespace nacre
