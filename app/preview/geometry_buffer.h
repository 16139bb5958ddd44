// The geometry pass: what the camera sees of the object, whatever it is made of and however it is lit.
#pragma once

#include <memory>
#include <optional>

#include "app/preview/gl_objects.h"
#include "app/preview/mesh_buffer.h"
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

    // xyz: normal, view space; w: the part of the texel that the object covers
    const Texture& normals() const { return target_.texture(0); }
    const Texture& tangents() const { return target_.texture(1); }  // xyz: view space; w: z of the point
    SurfaceImage read() const;

  private:
    // What the picture depends on.
    struct View {
        std::shared_ptr<const Mesh> mesh;  // none: the sphere
        glm::ivec2 size{0};
        glm::dmat3 object_to_view{1};
        double pixels_per_unit = 0;
        bool operator==(const View&) const = default;
    };

    void use(const Program& program, const View& view) const;
    void draw_mesh(const View& view);
    void draw_coverage(const View& view);
    void fill(glm::ivec2 size);
    void resize(glm::ivec2 size);

    Program sphere_, mesh_, outline_, fill_;
    FullScreen full_screen_;
    Target target_{2};
    Target middles_{2};  // of a mesh: what stands at each texel's middle
    Renderbuffer depth_;
    Renderbuffer samples_;  // whether the mesh covers them, several a texel
    Target many_samples_{0};
    Target covered_;
    MeshBuffer triangles_;
    std::shared_ptr<const Mesh> stored_;  // in triangles_
    glm::ivec2 size_{0};                  // of depth_ and samples_
    std::optional<View> drawn_;
};

}  // namespace nacre
