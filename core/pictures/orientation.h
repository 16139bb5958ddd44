// Pictures that were stored lying or mirrored; `orientation` is EXIF's, 1 to 8.
#pragma once

#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace nacre {

inline bool transposes(int orientation) { return orientation >= 5; }

inline glm::ivec2 upright_size(glm::ivec2 stored, int orientation) {
    return transposes(orientation) ? glm::ivec2(stored.y, stored.x) : stored;
}

// Where a pixel of the upright picture is stored.
inline glm::ivec2 stored_place(glm::ivec2 place, glm::ivec2 stored, int orientation) {
    const bool flips_x = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool flips_y = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    if (transposes(orientation)) std::swap(place.x, place.y);
    return {flips_x ? stored.x - 1 - place.x : place.x, flips_y ? stored.y - 1 - place.y : place.y};
}

// Where a stored pixel is in the upright picture.
inline glm::ivec2 upright_place(glm::ivec2 place, glm::ivec2 stored, int orientation) {
    const bool flips_x = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool flips_y = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    if (flips_x) place.x = stored.x - 1 - place.x;
    if (flips_y) place.y = stored.y - 1 - place.y;
    if (transposes(orientation)) std::swap(place.x, place.y);
    return place;
}

template <class Pixel>
std::vector<Pixel> upright(std::vector<Pixel> pixels, glm::ivec2 stored, int orientation) {
    if (orientation <= 1) return pixels;
    const glm::ivec2 size = upright_size(stored, orientation);
    std::vector<Pixel> turned;
    turned.reserve(pixels.size());
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::ivec2 from = stored_place({x, y}, stored, orientation);
            turned.push_back(pixels[static_cast<std::size_t>(from.y) * static_cast<std::size_t>(stored.x) +
                                    static_cast<std::size_t>(from.x)]);
        }
    return turned;
}

}  // namespace nacre
