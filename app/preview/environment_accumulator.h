// The light of an environment that the object's texels have gathered so far, sample after sample.
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

    // Forgets what was gathered.
    void restart(glm::ivec2 texels);

    // Adds samples to some rows of texels, `most` samples of single texels at the most but a row in any case,
    // and no more than `goal` samples to each. `program` is in use with its surface uploaded, and shades
    // gather.frag. Returns how many samples of single texels that were.
    double add(const Program& program, const GeometryBuffer& geometry, const Scene& scene, double most,
               int goal);

    int samples() const { return samples_; }  // that every texel has
    const Texture& gathered() const { return target_.texture(); }

    // The uniforms of environment.glsl; the picture goes to texture unit `unit`.
    void upload_surroundings(const Program& program, const Scene& scene, int unit) const;

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
