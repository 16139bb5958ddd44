// What lies under each pixel of the preview, as numbers.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace nacre {

// A point of the object, in view space (x right, y up, z toward the viewer).
struct SurfacePoint {
    glm::dmat3 frame{1};  // tangent, bitangent, normal
    glm::dvec3 position{0};
};

// The geometry buffer's texels, one a pixel.
class SurfaceImage {
  public:
    SurfaceImage() = default;
    // RGBA as shaders/surface.frag has them, bottom row first.
    SurfaceImage(glm::ivec2 size, double pixels_per_unit, std::vector<float> normals,
                 std::vector<float> tangents);

    glm::ivec2 size() const { return size_; }

    // The point under the middle of the pixel that holds this place (from the top left corner); nothing
    // beside the object.
    std::optional<SurfacePoint> at(glm::dvec2 place) const;

    // The same for the pixel of the object that is nearest to the place; nothing when none shows it.
    std::optional<SurfacePoint> nearest(glm::dvec2 place) const;

    // Whether more than half of the pixel (from the top left corner) shows the object.
    bool covered(glm::ivec2 pixel) const;

  private:
    std::size_t texel(glm::ivec2 pixel) const;

    glm::ivec2 size_{0};
    double pixels_per_unit_ = 1;
    std::vector<float> normals_, tangents_;
};

}  // namespace nacre
