#include "core/light/procedural.h"

#include <tbb/parallel_for.h>

#include <array>

namespace nacre {

std::span<const ProceduralEnvironment* const> procedural_environments() {
    static const std::array list{
#define ENVIRONMENT(name) &name##_environment,
#include "core/light/environment_list.inc"
#undef ENVIRONMENT
    };
    return list;
}

std::optional<LatLong> procedural_environment(std::string_view name, std::optional<int> width) {
    for (const ProceduralEnvironment* known : procedural_environments())
        if (known->name == name) return known->picture(width.value_or(known->width));
    return {};
}

LatLong painted_environment(int width, const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    LatLong picture{width, width / 2, {}};
    picture.radiance.resize(static_cast<std::size_t>(picture.width) *
                            static_cast<std::size_t>(picture.height));
    const glm::dvec2 size(picture.width, picture.height);
    tbb::parallel_for(0, picture.height, [&](int row) {
        for (int column = 0; column < picture.width; ++column)
            picture.radiance[static_cast<std::size_t>(row * width + column)] =
                radiance(lat_long_direction((glm::dvec2(column, row) + 0.5) / size));
    });
    return picture;
}

}  // namespace nacre
