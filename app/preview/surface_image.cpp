#include "app/preview/surface_image.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace nacre {

SurfaceImage::SurfaceImage(glm::ivec2 size, double pixels_per_unit, std::vector<float> normals,
                           std::vector<float> tangents)
    : size_(size),
      pixels_per_unit_(pixels_per_unit),
      normals_(std::move(normals)),
      tangents_(std::move(tangents)) {}

std::size_t SurfaceImage::texel(glm::ivec2 pixel) const {
    return (static_cast<std::size_t>(size_.y - 1 - pixel.y) * static_cast<std::size_t>(size_.x) +
            static_cast<std::size_t>(pixel.x)) *
           4;
}

bool SurfaceImage::covered(glm::ivec2 pixel) const { return normals_[texel(pixel) + 3] > 0.5f; }

std::optional<SurfacePoint> SurfaceImage::at(glm::dvec2 place) const {
    if (!(place.x >= 0 && place.y >= 0 && place.x < size_.x && place.y < size_.y)) return {};
    const glm::ivec2 pixel(glm::floor(place));
    if (!covered(pixel)) return {};
    const float* const n = &normals_[texel(pixel)];
    const float* const t = &tangents_[texel(pixel)];
    const glm::dvec3 normal(n[0], n[1], n[2]), tangent(t[0], t[1], t[2]);
    const glm::dvec2 across = (glm::dvec2(pixel) + 0.5 - 0.5 * glm::dvec2(size_)) / pixels_per_unit_;
    return SurfacePoint{{tangent, glm::cross(normal, tangent), normal}, {across.x, -across.y, t[3]}};
}

std::optional<SurfacePoint> SurfaceImage::nearest(glm::dvec2 place) const {
    if (auto here = at(place)) return here;
    double least = HUGE_VAL;
    glm::dvec2 found{0};
    for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) {
            const glm::dvec2 middle(x + 0.5, y + 0.5);
            const double distance = glm::dot(middle - place, middle - place);
            if (distance >= least || !covered({x, y})) continue;
            least = distance;
            found = middle;
        }
    return at(found);
}

}  // namespace nacre
