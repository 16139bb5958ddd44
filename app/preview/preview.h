// The object: the newest tables, drawn into a texture. Needs a current OpenGL 3.3 core context.
#pragma once

#include <map>
#include <memory>

#include "app/preview/geometry_buffer.h"
#include "app/preview/gl_objects.h"
#include "app/preview/scene.h"
#include "app/preview/surface_image.h"
#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

class Preview {
  public:
    Preview();

    // What is drawn from now on. The tables hold all that the shader needs of their design.
    void set(std::shared_ptr<const Tables> tables);
    bool empty() const { return !tables_; }

    // The developed picture (exposure, filmic curve, sRGB) as RGBA8 in texture(), top row last as OpenGL has
    // it. `supersample` x `supersample` samples a pixel.
    void draw(const Scene& scene, glm::ivec2 size, int supersample);
    GLuint texture() const { return developed_.texture().name(); }

    // The same as numbers: RGBA, bottom row first; developed to sRGB in [0, 1], or linear radiance times
    // exposure.
    std::vector<float> picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear);

    // What lies under the pixels of a picture of this size: read back when the object, the camera or the size
    // has changed.
    const SurfaceImage& surface(const Scene& scene, glm::ivec2 size);

  private:
    const Program& surface_program(const Scene& scene);
    void draw_radiance(const Scene& scene, glm::ivec2 size, int supersample);
    void develop(const Scene& scene, glm::ivec2 size, int supersample, bool linear);

    std::shared_ptr<const Tables> tables_;
    Texture data_;
    FullScreen full_screen_;
    Program develop_;
    std::map<std::string, std::unique_ptr<Program>> surfaces_;  // by the text of their fragment shader
    GeometryBuffer geometry_;
    GeometryBuffer pixel_geometry_;
    SurfaceImage surface_;
    Target radiance_;
    Target developed_;
};

}  // namespace nacre
