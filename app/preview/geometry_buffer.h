// The geometry pass: what the camera sees of the object, whatever it is made of and however it is lit.
#pragma once

#include <optional>

#include "app/preview/gl_objects.h"
#include "app/preview/scene.h"
#include "app/preview/surface_image.h"

namespace nacre {

// Needs a current OpenGL 3.3 core context.
class GeometryBuffer {
  public:
    GeometryBuffer();

    // Draws the object at the middle of `size` texels, unless just that stands there already. Returns whether
    // it drew.
    bool update(const Scene& scene, glm::ivec2 size);

    const Texture& normals() const {
        return target_.texture(0);
    }  // xyz: view space; w: part of the texel covered
    const Texture& tangents() const { return target_.texture(1); }  // xyz: view space; w: z of the point
    SurfaceImage read() const;

  private:
    // What the picture depends on.
    struct View {
        glm::ivec2 size{0};
        glm::dmat3 object_to_view{1};
        double pixels_per_unit = 0;
        bool operator==(const View&) const = default;
    };

    Program sphere_;
    FullScreen full_screen_;
    Target target_{2};
    std::optional<View> drawn_;
};

}  // namespace nacre
