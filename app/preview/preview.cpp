#include "app/preview/preview.h"

#include <cmath>

#include "app/preview/upload.h"
#include "core/exchange/shader_variant.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr std::size_t programs_kept = 24;  // variants that an editing session may go back and forth between

std::string text(const char* name) { return std::string(shader_text(name)); }

// OpenGL state that whoever draws around the preview relies on.
class SavedState {
  public:
    SavedState() {
        glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer_);
        glGetIntegerv(GL_VIEWPORT, viewport_);
    }
    ~SavedState() {
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        glUseProgram(0);
        glActiveTexture(GL_TEXTURE0);
    }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

  private:
    GLint framebuffer_ = 0;
    GLint viewport_[4] = {};
};

}  // namespace

Preview::Preview() : develop_(text("full_screen.vert"), text("develop.frag")) {}

void Preview::set(std::shared_ptr<const Tables> tables) {
    tables_ = std::move(tables);
    store_data(data_, tables_->data);
}

const Program& Preview::surface_program(const Scene& scene) {
    ShaderVariant variant = variant_of(tables_->shading);
    variant.lights = static_cast<int>(lights_of(scene).size());
    variant.ambient = scene.ambient && variant.kinds.albedo;
    const std::string fragment = fragment_shader(variant, "surface.frag");
    if (surfaces_.size() > programs_kept && !surfaces_.count(fragment)) surfaces_.clear();
    std::unique_ptr<Program>& program = surfaces_[fragment];
    if (!program) program = std::make_unique<Program>(text("full_screen.vert"), fragment);
    return *program;
}

void Preview::draw_radiance(const Scene& scene, glm::ivec2 size, int supersample) {
    const Program& program = surface_program(scene);
    const glm::ivec2 texels = size * supersample;
    geometry_.update(scene, texels);
    radiance_.bind(texels, GL_RGBA32F);
    glUseProgram(program.name());
    data_.bind(0);
    geometry_.normals().bind(1);
    geometry_.tangents().bind(2);
    upload_surface(program, tables_->shading, 0);
    set_uniform(program, "normals", 1);
    set_uniform(program, "tangents", 2);
    set_uniform(program, "target_size", glm::dvec2(texels));
    set_uniform(program, "texels_per_unit", pixels_per_unit(scene, texels));
    int index = 0;
    for (const LightSource& light : lights_of(scene)) {
        const std::string at = "[" + std::to_string(index++) + "]";
        set_uniform(program, ("light_direction" + at).c_str(), light_direction(light));
        set_uniform(program, ("light_irradiance" + at).c_str(), light.irradiance);
    }
    set_uniform(program, "ambient_radiance", scene.ambient_radiance);
    const Backdrop backdrop = backdrop_of(scene);
    set_uniform(program, "background", backdrop.radiance);
    set_uniform(program, "falloff", backdrop.falls_off ? 1.0 : 0.0);
    full_screen_.draw();
}

void Preview::develop(const Scene& scene, glm::ivec2 size, int supersample, bool linear) {
    developed_.bind(size, linear ? GL_RGBA32F : GL_RGBA8);
    glUseProgram(develop_.name());
    radiance_.texture().bind(0);
    set_uniform(develop_, "radiance", 0);
    set_uniform(develop_, "supersample", supersample);
    set_uniform(develop_, "exposure", std::exp2(scene.exposure));
    set_uniform(develop_, "linear", linear ? 1 : 0);
    full_screen_.draw();
}

void Preview::draw(const Scene& scene, glm::ivec2 size, int supersample) {
    const SavedState state;
    draw_radiance(scene, size, supersample);
    develop(scene, size, supersample, false);
}

std::vector<float> Preview::picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear) {
    const SavedState state;
    draw_radiance(scene, size, supersample);
    develop(scene, size, supersample, linear);
    return developed_.read();
}

const SurfaceImage& Preview::surface(const Scene& scene, glm::ivec2 size) {
    const SavedState state;
    if (pixel_geometry_.update(scene, size)) surface_ = pixel_geometry_.read();
    return surface_;
}

}  // namespace nacre
