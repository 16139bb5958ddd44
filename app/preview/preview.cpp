#include "app/preview/preview.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/preview/upload.h"
#include "core/exchange/shader_variant.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr std::size_t programs_kept = 24;  // variants that an editing session may go back and forth between
constexpr double background_slope =
    0.25;  // of surroundings: at the usual zoom about 35 degrees are in the picture
constexpr double gathered_at_once = 250e3;  // the same, where nobody waits for a frame
constexpr double least_gathered = 4096;     // samples of single texels: fewer tell nothing about the speed

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

const Program& Preview::program_of(const std::string& fragment) {
    if (programs_.size() > programs_kept && !programs_.count(fragment)) programs_.clear();
    std::unique_ptr<Program>& program = programs_[fragment];
    if (!program) program = std::make_unique<Program>(text("full_screen.vert"), fragment);
    return *program;
}

const Program& Preview::surface_program() {
    const Scene& scene = frame_.scene;
    ShaderVariant variant = variant_of(tables_->shading);
    variant.lights = static_cast<int>(lights_of(scene).size());
    variant.ambient = scene.ambient && lights_shine(scene) && variant.kinds.albedo;
    variant.surroundings = frame_.gathers() && scene.environment.visible;
    return program_of(fragment_shader(variant, "surface.frag"));
}

void Preview::draw_radiance() {
    const Scene& scene = frame_.scene;
    const glm::ivec2 texels = frame_.size * frame_.supersample;
    geometry_.update(scene, texels);
    if (frame_.gathers()) {
        gathering_.set_environment(scene.environment.picture);
        gathering_.set_facets(tables_);
        gathering_.restart(texels);
    }
    const Program& program = surface_program();
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
    set_uniform(program, "background_slope", background_slope);
    if (frame_.gathers()) gathering_.upload_surroundings(program, scene, 3);
    full_screen_.draw();
}

// See Gathering::add.
double Preview::gather(double most) {
    const Program& program = program_of(fragment_shader(variant_of(tables_->shading), "gather.frag"));
    glUseProgram(program.name());
    data_.bind(0);
    upload_surface(program, tables_->shading, 0);
    return gathering_.add(program, geometry_, frame_.scene, most, frame_.goal);
}

void Preview::develop(bool linear) {
    developed_.bind(frame_.size, linear ? GL_RGBA32F : GL_RGBA8);
    glUseProgram(develop_.name());
    radiance_.texture().bind(0);
    gathering_.gathered().bind(1);
    set_uniform(develop_, "radiance", 0);
    set_uniform(develop_, "gathered", 1);
    set_uniform(develop_, "surrounded", frame_.gathers() ? 1 : 0);
    set_uniform(develop_, "supersample", frame_.supersample);
    set_uniform(develop_, "exposure", std::exp2(frame_.scene.exposure));
    set_uniform(develop_, "linear", linear ? 1 : 0);
    full_screen_.draw();
}

void Preview::draw(const Scene& scene, glm::ivec2 size, int supersample) {
    const SavedState state;
    frame_ = {scene, size, supersample, 1};
    draw_radiance();
    while (frame_.gathers() && gathering_.samples() < frame_.goal) gather(gathered_at_once);
    develop(false);
}

void Preview::begin(const Scene& scene, glm::ivec2 size, int supersample, int goal) {
    const SavedState state;
    frame_ = {scene, size, supersample, std::max(goal / (supersample * supersample), 1)};
    draw_radiance();
}

void Preview::refine(double seconds) {
    if (!frame_.gathers() || gathering_.samples() >= frame_.goal) return;
    const SavedState state;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    do {
        const double before = passed();
        const double done = gather(std::max(gathers_a_second_ * (seconds - before), least_gathered));
        glFinish();  // the time that gathering takes decides how much of it fits
        gathers_a_second_ = done / std::max(passed() - before, 1e-6);
    } while (gathering_.samples() < frame_.goal && passed() < 0.7 * seconds);
    if (gathering_.samples() > 0) develop(false);
}

GatherProgress Preview::progress() const {
    if (!frame_.gathers()) return {};
    const int texels = frame_.supersample * frame_.supersample;
    return {gathering_.samples() * texels, frame_.goal * texels};
}

std::vector<float> Preview::picture(const Scene& scene, glm::ivec2 size, int supersample, bool linear,
                                    int samples, const std::function<bool(double)>& go_on) {
    const SavedState state;
    begin(scene, size, supersample, samples);
    while (frame_.gathers() && gathering_.samples() < frame_.goal) {
        if (go_on && !go_on(static_cast<double>(gathering_.samples()) / frame_.goal)) return {};
        gather(gathered_at_once);
        glFinish();
    }
    develop(linear);
    return developed_.read();
}

const SurfaceImage& Preview::surface(const Scene& scene, glm::ivec2 size) {
    const SavedState state;
    if (pixel_geometry_.update(scene, size)) surface_ = pixel_geometry_.read();
    return surface_;
}

}  // namespace nacre
