#include "app/preview/preview.h"

#include <cmath>
#include <numbers>

#include "app/preview/upload.h"
#include "core/exchange/shader_variant.h"
#include "core/paint/colour_map.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr std::size_t programs_kept = 24;  // variants that an editing session may go back and forth between
constexpr int colours = 256;               // of the map for numbers
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
        glActiveTexture(GL_TEXTURE0);
    }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

  private:
    GLint framebuffer_ = 0;
    GLint viewport_[4] = {};
};

}  // namespace

Preview::Preview() : develop_(text("full_screen.vert"), text("develop.frag")) {
    std::vector<glm::u8vec4> map;
    for (int i = 0; i < colours; ++i) map.emplace_back(inferno(i / (colours - 1.0)), 255);
    colours_.store({colours, 1}, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, map.data(), GL_LINEAR);
}

void Preview::set(std::shared_ptr<const Tables> tables, std::shared_ptr<const ClosedForm> model) {
    tables_ = std::move(tables);
    model_ = std::move(model);
    if (!model_) return store_data(data_, tables_->data);
    std::vector<float> data = tables_->data;
    data.insert(data.end(), model_->albedo.begin(), model_->albedo.end());
    store_data(data_, data);
}

FactorScale Preview::scale(const Scene& scene) const {
    return factor_scale(scene.term, *tables_, scene.exposure);
}

const Program& Preview::surface_program(const Scene& scene) {
    ShaderVariant variant = variant_of(tables_->shading);
    variant.second_light = scene.second_light;
    // A model whose albedo is not made yet waits for it in the dark, as a design does.
    variant.ambient = scene.ambient && variant.kinds.albedo && !(model_ && model_->albedo.empty());
    variant.term = scene.term;
    if (model_) variant.closed_form = model_->form.model;
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
    if (model_) upload_closed_form(program, model_->form);
    set_uniform(program, "normals", 1);
    set_uniform(program, "tangents", 2);
    set_uniform(program, "target_size", glm::dvec2(texels));
    set_uniform(program, "texels_per_unit", pixels_per_unit(scene, texels));
    set_uniform(program, "light_direction", light_direction(scene.light));
    set_uniform(program, "light_irradiance", scene.light.irradiance);
    set_uniform(program, "second_direction", light_direction(scene.second));
    set_uniform(program, "second_irradiance", scene.second.irradiance);
    set_uniform(program, "ambient_radiance", scene.ambient_radiance);
    set_uniform(program, "background", background);
    full_screen_.draw();
}

void Preview::develop(Target& target, const Development& how, glm::ivec2 size, int supersample) {
    target.bind(size, how.linear ? GL_RGBA32F : GL_RGBA8);
    glUseProgram(develop_.name());
    radiance_.texture().bind(0);
    colours_.bind(1);
    set_uniform(develop_, "radiance", 0);
    set_uniform(develop_, "colours", 1);
    set_uniform(develop_, "supersample", supersample);
    set_uniform(develop_, "exposure", how.exposure);
    set_uniform(develop_, "linear", how.linear ? 1 : 0);
    set_uniform(develop_, "is_factor", how.factor ? 1 : 0);
    if (how.factor) {
        set_uniform(develop_, "coloured", how.factor->coloured ? 1 : 0);
        set_uniform(develop_, "logarithmic", how.factor->logarithmic ? 1 : 0);
        set_uniform(develop_, "low", how.factor->low);
        set_uniform(develop_, "high", how.factor->high);
    }
    full_screen_.draw();
}

void Preview::develop_as_seen(const Scene& scene, glm::ivec2 size, int supersample) {
    Development how{.exposure = std::exp2(scene.exposure)};
    // A factor's scale holds the exposure.
    if (is_factor(scene.term)) how = {.factor = shown_scale(scene)};
    develop(developed_, how, size, supersample);
}

std::vector<float> Preview::numbers(glm::ivec2 size, int supersample) {
    const SavedState state;
    develop(numbers_, {.linear = true}, size, supersample);
    return numbers_.read();
}

void Preview::draw(const Scene& scene, glm::ivec2 size, int supersample) {
    const SavedState state;
    draw_radiance(scene, size, supersample);
    develop_as_seen(scene, size, supersample);
}

std::vector<float> Preview::picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear) {
    const SavedState state;
    draw_radiance(scene, size, supersample);
    if (!linear) {
        develop_as_seen(scene, size, supersample);
        return developed_.read();
    }
    develop(numbers_, {.exposure = std::exp2(scene.exposure), .linear = true}, size, supersample);
    return numbers_.read();
}

const SurfaceImage& Preview::surface(const Scene& scene, glm::ivec2 size) {
    const SavedState state;
    if (pixel_geometry_.update(scene, size)) surface_ = pixel_geometry_.read();
    return surface_;
}

}  // namespace nacre
