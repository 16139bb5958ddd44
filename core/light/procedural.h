// Environments that are formulas: one file for each, core/light/environments/NAME.cpp, and its line in
// environment_list.inc.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "core/image/lat_long.h"

namespace nacre {

struct ProceduralEnvironment {
    const char* name;   // what a program says
    const char* label;  // what a person reads
    const char* about;
    int width;                      // texels, unless another is asked for; the height is half of it
    LatLong (*picture)(int width);  // radiance, linear Rec. 709
};

std::span<const ProceduralEnvironment* const> procedural_environments();

#define ENVIRONMENT(name) extern const ProceduralEnvironment name##_environment;
#include "core/light/environment_list.inc"
#undef ENVIRONMENT

// At their usual size, or `width` x `width`/2 texels. Nothing for a name that is none.
std::optional<LatLong> procedural_environment(std::string_view name, std::optional<int> width = {});

// `radiance` at the middle of each texel.
LatLong painted_environment(int width, const std::function<glm::dvec3(glm::dvec3)>& radiance);

}  // namespace nacre
