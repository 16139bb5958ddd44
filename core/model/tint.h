// What the layers' tints make of the specular term: q = sum of w tint p over the layers takes the place of p.
#pragma once

#include <glm/vec3.hpp>

namespace nacre {

struct Distribution;

// Of all layers that hold facets.
enum class Tint {
    none,    // each is 1
    shared,  // one for all: a factor
    varied   // they differ, so that each colour has an R of its own
};

Tint tint_of(const Distribution& distribution);

// Over all facets, by their area.
glm::dvec3 mean_tint(const Distribution& distribution);

}  // namespace nacre
