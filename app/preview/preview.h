// The object: the newest tables, drawn into a texture. Needs a current OpenGL 3.3 core context.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "app/preview/factor_scale.h"
#include "app/preview/geometry_buffer.h"
#include "app/preview/gl_objects.h"
#include "app/preview/scene.h"
#include "app/preview/surface_image.h"
#include "core/bake/tables.h"
#include "core/design/design.h"
#include "core/measure/closed_form.h"

namespace nacre {

class Preview {
  public:
    Preview();

    // What is drawn from now on. The tables hold all that the shader needs of their design; a model stands in
    // the place of their own BRDF.
    void set(std::shared_ptr<const Tables> tables, std::shared_ptr<const ClosedForm> model = nullptr);
    bool empty() const { return !tables_; }

    // The developed picture (exposure, filmic curve, sRGB) as RGBA8 in texture(), top row last as OpenGL has
    // it. `supersample` x `supersample` samples a pixel.
    void draw(const Scene& scene, glm::ivec2 size, int supersample);
    GLuint texture() const { return developed_.texture().name(); }

    // The same as numbers: RGBA, bottom row first; developed to sRGB in [0, 1], or linear radiance times
    // exposure.
    std::vector<float> picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear);

    // What was drawn last, as linear radiance without exposure (of a factor, as that): RGBA, bottom row
    // first.
    std::vector<float> numbers(glm::ivec2 size, int supersample);

    // How the factor that a scene shows becomes colours; another scale than its own, to compare.
    FactorScale scale(const Scene& scene) const;
    FactorScale shown_scale(const Scene& scene) const { return given_scale_.value_or(scale(scene)); }
    void use_scale(const std::optional<FactorScale>& scale) { given_scale_ = scale; }

    // What lies under the pixels of a picture of this size: read back when the object, the camera or the size
    // has changed.
    const SurfaceImage& surface(const Scene& scene, glm::ivec2 size);

  private:
    const Program& surface_program(const Scene& scene);
    void draw_radiance(const Scene& scene, glm::ivec2 size, int supersample);
    // See shaders/develop.frag.
    struct Development {
        double exposure = 1;  // factor
        bool linear = false;
        std::optional<FactorScale> factor = {};
    };
    void develop(Target& target, const Development& how, glm::ivec2 size, int supersample);
    void develop_as_seen(const Scene& scene, glm::ivec2 size, int supersample);

    std::shared_ptr<const Tables> tables_;
    std::shared_ptr<const ClosedForm> model_;
    std::optional<FactorScale> given_scale_;
    Texture data_;
    FullScreen full_screen_;
    Program develop_;
    Texture colours_;                                           // of numbers
    std::map<std::string, std::unique_ptr<Program>> surfaces_;  // by the text of their fragment shader
    GeometryBuffer geometry_;
    GeometryBuffer pixel_geometry_;
    SurfaceImage surface_;
    Target radiance_;
    Target developed_;
    Target numbers_;
};

}  // namespace nacre
