#include "app/preview/preview.h"

#include <cmath>
#include <numbers>

#include "app/preview/upload.h"
#include "core/exchange/shader_variant.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr std::size_t programs_kept = 24;  // variants that an editing session may go back and forth between
constexpr glm::dvec3 background{0.045, 0.047, 0.052};

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

const Program& Preview::sphere_program(const Scene& scene) {
    ShaderVariant variant = variant_of(tables_->shading);
    variant.second_light = scene.second_light;
    variant.ambient = scene.ambient && variant.kinds.albedo;
    const std::string fragment = fragment_shader(variant, "sphere.frag");
    if (spheres_.size() > programs_kept && !spheres_.count(fragment)) spheres_.clear();
    std::unique_ptr<Program>& program = spheres_[fragment];
    if (!program) program = std::make_unique<Program>(text("full_screen.vert"), fragment);
    return *program;
}

void Preview::draw_radiance(const Scene& scene, glm::ivec2 size, int supersample) {
    const Program& program = sphere_program(scene);
    const glm::ivec2 texels = size * supersample;
    radiance_.bind(texels, GL_RGBA32F);
    glUseProgram(program.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, data_.name());
    upload_surface(program, tables_->shading, 0);
    set_uniform(program, "target_size", glm::dvec2(texels));
    set_uniform(program, "texels_per_unit", pixels_per_unit(scene, size) * supersample);
    set_uniform(program, "object_to_view", object_to_view(scene));
    set_uniform(program, "light_direction", light_direction(scene.light));
    set_uniform(program, "light_irradiance", scene.light.irradiance);
    set_uniform(program, "second_direction", light_direction(scene.second));
    set_uniform(program, "second_irradiance", scene.second.irradiance);
    set_uniform(program, "ambient_radiance", scene.ambient_radiance);
    set_uniform(program, "background", background);
    // Nobody reads its alpha, and Mesa's software renderer compiles a shader that writes all of a texel
    // twice.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    full_screen_.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Preview::develop(const Scene& scene, glm::ivec2 size, int supersample, bool linear) {
    developed_.bind(size, linear ? GL_RGBA32F : GL_RGBA8);
    glUseProgram(develop_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, radiance_.texture().name());
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

}  // namespace nacre
