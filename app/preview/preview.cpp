#include "app/preview/preview.h"

#include <algorithm>
#include <cmath>

#include "app/preview/upload.h"
#include "core/base/stopwatch.h"
#include "core/paint/colour_map.h"
#include "core/shading/shader_variant.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr std::size_t programs_kept = 24;  // variants that an editing session may go back and forth between
constexpr int colours = 256;               // of the map for numbers
constexpr double background_slope =
    0.25;  // of an environment: at the usual zoom about 35 degrees are in the picture
constexpr double samples_at_once = 250e3;  // the same, where nobody waits for a frame
constexpr double samples_min = 4096;       // samples of single texels: fewer tell nothing about the speed

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

const Program& Preview::program_of(const std::string& fragment) {
    if (programs_.size() > programs_kept && !programs_.count(fragment)) programs_.clear();
    std::unique_ptr<Program>& program = programs_[fragment];
    if (!program) program = std::make_unique<Program>(text("full_screen.vert"), fragment);
    return *program;
}

ShaderVariant Preview::variant() const {
    ShaderVariant variant = variant_of(tables_->shading);
    variant.term = frame_.scene.term;
    if (model_) variant.closed_form = model_->form.model;
    return variant;
}

const Program& Preview::surface_program() {
    const Scene& scene = frame_.scene;
    ShaderVariant chosen = variant();
    chosen.lights = static_cast<int>(lights_of(scene).size());
    // A model whose albedo is not made yet waits for it in the dark, as a design does.
    const bool known = chosen.kinds.albedo && !(model_ && model_->albedo.empty());
    chosen.ambient = scene.ambient && lights_shine(scene) && known;
    chosen.environment_behind = frame_.uses_environment() && scene.environment.visible;
    return program_of(fragment_shader(chosen, "surface.frag"));
}

void Preview::draw_radiance() {
    const Scene& scene = frame_.scene;
    const glm::ivec2 texels = frame_.size * frame_.supersample;
    geometry_.update(scene, texels);
    if (frame_.uses_environment()) {
        accumulator_.set_environment(scene.environment.picture);
        accumulator_.set_facets(tables_);
        accumulator_.restart(texels);
    }
    const Program& program = surface_program();
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
    set_uniform(program, "background_slope", background_slope);
    if (frame_.uses_environment()) accumulator_.upload_environment(program, scene, 3);
    // Nobody reads its alpha, and Mesa's software renderer compiles a shader that writes all of a texel
    // twice.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    full_screen_.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// See EnvironmentAccumulator::add.
double Preview::accumulate(double most) {
    const Program& program = program_of(fragment_shader(variant(), "accumulate.frag"));
    glUseProgram(program.name());
    data_.bind(0);
    upload_surface(program, tables_->shading, 0);
    if (model_) upload_closed_form(program, model_->form);
    return accumulator_.add(program, geometry_, frame_.scene, most, frame_.goal);
}

void Preview::develop(Target& target, const Development& how) {
    target.bind(frame_.size, how.linear ? GL_RGBA32F : GL_RGBA8);
    glUseProgram(develop_.name());
    radiance_.texture().bind(0);
    colours_.bind(1);
    accumulator_.accumulated().bind(2);
    set_uniform(develop_, "radiance", 0);
    set_uniform(develop_, "colours", 1);
    set_uniform(develop_, "accumulated", 2);
    set_uniform(develop_, "has_environment", frame_.uses_environment() ? 1 : 0);
    set_uniform(develop_, "supersample", frame_.supersample);
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

void Preview::develop_as_seen() {
    Development how{.exposure = std::exp2(frame_.scene.exposure)};
    // A factor's scale holds the exposure.
    if (is_factor(frame_.scene.term)) {
        if (!given_scale_) drawn_scale_ = scale(frame_.scene);
        how = {.factor = shown_scale()};
    }
    develop(developed_, how);
}

std::vector<float> Preview::numbers() {
    const SavedState state;
    develop(numbers_, {.linear = true});
    return numbers_.read();
}

void Preview::draw(const Scene& scene, glm::ivec2 size, int supersample) {
    const SavedState state;
    frame_ = {scene, size, supersample, 1};
    draw_radiance();
    while (frame_.uses_environment() && accumulator_.samples() < frame_.goal) accumulate(samples_at_once);
    develop_as_seen();
}

void Preview::begin(const Scene& scene, glm::ivec2 size, int supersample, int goal) {
    const SavedState state;
    frame_ = {scene, size, supersample, std::max(goal / (supersample * supersample), 1)};
    draw_radiance();
}

void Preview::refine(double seconds) {
    if (!frame_.uses_environment() || accumulator_.samples() >= frame_.goal) return;
    const SavedState state;
    const Stopwatch passed;
    do {
        const double before = passed.seconds();
        const double done = accumulate(std::max(samples_a_second_ * (seconds - before), samples_min));
        glFinish();  // the time that accumulating takes decides how much of it fits
        samples_a_second_ = done / std::max(passed.seconds() - before, 1e-6);
    } while (accumulator_.samples() < frame_.goal && passed.seconds() < 0.7 * seconds);
    if (accumulator_.samples() > 0) develop_as_seen();
}

SampleProgress Preview::progress() const {
    if (!frame_.uses_environment()) return {};
    const int texels = frame_.supersample * frame_.supersample;
    return {accumulator_.samples() * texels, frame_.goal * texels};
}

std::vector<float> Preview::picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear,
                                    int samples, const std::function<bool(double)>& go_on) {
    const SavedState state;
    begin(scene, size, supersample, samples);
    while (frame_.uses_environment() && accumulator_.samples() < frame_.goal) {
        if (go_on && !go_on(static_cast<double>(accumulator_.samples()) / frame_.goal)) return {};
        accumulate(samples_at_once);
        glFinish();
    }
    if (!linear) {
        develop_as_seen();
        return developed_.read();
    }
    develop(numbers_, {.exposure = std::exp2(scene.exposure), .linear = true});
    return numbers_.read();
}

const SurfaceImage& Preview::surface(const Scene& scene, glm::ivec2 size) {
    const SavedState state;
    if (pixel_geometry_.update(scene, size)) surface_ = pixel_geometry_.read();
    return surface_;
}

}  // namespace nacre
