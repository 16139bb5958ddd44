// Light of an environment at the object's texels, accumulated sample by sample.
#pragma once

#include <memory>

#include "app/preview/geometry_buffer.h"
#include "app/preview/gl_objects.h"
#include "app/preview/scene.h"
#include "core/bake/tables.h"
#include "core/light/environment.h"

namespace nacre {

// Needs a current OpenGL 3.3 core context.
class EnvironmentAccumulator {
  public:
    // What is drawn from. Each costs tens of milliseconds where it is not what it was.
    void set_environment(std::shared_ptr<const Environment> environment);
    void set_facets(const std::shared_ptr<const Tables>& tables);

    // Forgets all samples.
    void restart(glm::ivec2 texels);

    // Adds samples to some rows of texels, at most `most` samples of single texels but a row in any case,
    // and no more than `goal` samples to each. `program` is in use with its surface uploaded, and shades
    // accumulate.frag. Returns how many samples of single texels that were.
    double add(const Program& program, const GeometryBuffer& geometry, const Scene& scene, double most,
               int goal);

    int samples() const { return samples_; }  // that every texel has
    const Texture& accumulated() const { return target_.texture(); }

    // The uniforms of environment.glsl; the picture goes to texture unit `unit`.
    void upload_environment(const Program& program, const Scene& scene, int unit) const;

  private:
    std::shared_ptr<const Environment> environment_;
    std::shared_ptr<const Tables> facets_of_;
    Texture picture_, light_order_, facet_order_;
    FullScreen full_screen_;
    Target target_;
    glm::ivec2 texels_{0};
    int samples_ = 0;
    int batch_ = 0;  // samples that the rows below `row_` are ahead
    int row_ = 0;
};

}  // namespace nacre
