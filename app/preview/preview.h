// The object: the newest tables, drawn into a texture. Needs a current OpenGL 3.3 core context.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "app/preview/environment_accumulator.h"
#include "app/preview/factor_scale.h"
#include "app/preview/geometry_buffer.h"
#include "app/preview/gl_objects.h"
#include "app/preview/scene.h"
#include "app/preview/surface_image.h"
#include "core/bake/tables.h"
#include "core/compare/closed_form.h"
#include "core/design/design.h"
#include "core/shading/shader_variant.h"

namespace nacre {

// Samples a pixel of an environment so far and in all; 0 of 0 without one.
struct SampleProgress {
    int samples = 0, goal = 0;
    bool operator==(const SampleProgress&) const = default;
};

inline constexpr int usual_samples = 1024;

class Preview {
  public:
    Preview();

    // What is drawn from now on. The tables hold all that the shader needs of their design; a model stands in
    // the place of their own BRDF.
    void set(std::shared_ptr<const Tables> tables, std::shared_ptr<const ClosedForm> model = nullptr);
    bool empty() const { return !tables_; }

    // The developed picture (exposure, filmic curve, sRGB) as RGBA8 in texture(), top row last as OpenGL has
    // it. `supersample` x `supersample` texels a pixel; of an environment's light one sample a texel.
    void draw(const Scene& scene, glm::ivec2 size, int supersample);
    GLuint texture() const { return developed_.texture().name(); }

    // The same for a picture that an environment lights, in parts: begin() leaves texture() as it is, and
    // each refine() goes on for about so long, until there are `goal` samples a pixel; what they have shows
    // as soon as each texel has one.
    void begin(const Scene& scene, glm::ivec2 size, int supersample, int goal);
    void refine(double seconds);
    SampleProgress progress() const;

    // What one sample of one texel took when last refined; 0 where that is not known.
    double seconds_a_sample() const { return samples_a_second_ > 0 ? 1 / samples_a_second_ : 0; }

    // The same as numbers: RGBA, bottom row first; developed to sRGB in [0, 1], or linear radiance times
    // exposure. With about so many samples a pixel of an environment's light; `go_on` is asked now and then,
    // with the part that is done.
    std::vector<float> picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear,
                               int samples = 1, const std::function<bool(double)>& go_on = {});

    // What was drawn last, as linear radiance without exposure (of a factor, as that): RGBA, bottom row
    // first.
    std::vector<float> numbers();

    // How the factor that a scene shows becomes colours; what was drawn last, or another scale than its own,
    // to compare.
    FactorScale scale(const Scene& scene) const;
    FactorScale shown_scale() const { return given_scale_.value_or(drawn_scale_); }
    void use_scale(const std::optional<FactorScale>& scale) { given_scale_ = scale; }

    // What lies under the pixels of a picture of this size: read back when the object, the camera or the size
    // has changed.
    const SurfaceImage& surface(const Scene& scene, glm::ivec2 size);

  private:
    // A picture that is being drawn.
    struct Frame {
        Scene scene;
        glm::ivec2 size{0};
        int supersample = 1;
        int goal = 0;  // samples a texel

        bool uses_environment() const { return nacre::uses_environment(scene); }
    };

    // See shaders/develop.frag.
    struct Development {
        double exposure = 1;  // factor
        bool linear = false;
        std::optional<FactorScale> factor = {};
    };

    const Program& program_of(const std::string& fragment);
    ShaderVariant variant() const;
    const Program& surface_program();
    void draw_radiance();
    double accumulate(double most);
    void develop(Target& target, const Development& how);
    void develop_as_seen();

    std::shared_ptr<const Tables> tables_;
    std::shared_ptr<const ClosedForm> model_;
    std::optional<FactorScale> given_scale_;
    FactorScale drawn_scale_;  // of its own: looking for the peak of p takes a part of a frame
    Texture data_;
    FullScreen full_screen_;
    Program develop_;
    Texture colours_;                                           // of numbers
    std::map<std::string, std::unique_ptr<Program>> programs_;  // by the text of their fragment shader
    GeometryBuffer geometry_;
    GeometryBuffer pixel_geometry_;
    SurfaceImage surface_;
    Target radiance_;
    EnvironmentAccumulator accumulator_;
    Frame frame_;
    double samples_a_second_ = 0;  // samples of single texels; 0 until measured
    Target developed_;
    Target numbers_;
};

}  // namespace nacre
