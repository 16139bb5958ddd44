// Environments that are formulas.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/light/lat_long.h"

namespace nacre {

// What a program says and what a person reads.
struct EnvironmentName {
    std::string name;
    std::string label;
    std::string about;
};

// "studio": soft boxes in a dark room; "sky": a clear sky with its sun over grey ground; "furnace": radiance
// 1 from everywhere; "octants": another colour from each octant, to see that nothing is mirrored.
const std::vector<EnvironmentName>& procedural_environments();

// At their usual size, or `width` x `width`/2 texels. Nothing for a name that is none.
std::optional<LatLong> procedural_environment(std::string_view name, std::optional<int> width = {});

}  // namespace nacre
