#include "app/preview/environment_accumulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/preview/upload.h"
#include "core/light/facet_order.h"

namespace nacre {
namespace {

constexpr int order_width = 256;  // of shaders/draw.glsl
constexpr int batch_max = 64;     // samples of one drawing: a graphics driver gives up on what takes seconds
// Cells a hemisphere has each way: a draft is looked at for a moment.
constexpr int draft_side = 128, final_side = 512;

void store_order(Texture& texture, const DirectionOrder& order) {
    const int rows = (static_cast<int>(order.texels.size()) + order_width - 1) / order_width;
    std::vector<glm::vec4> padded(order.texels);
    padded.resize(static_cast<std::size_t>(rows) * order_width);
    texture.store({order_width, rows}, GL_RGBA32F, GL_RGBA, GL_FLOAT, padded.data(), GL_NEAREST);
}

// Turns what stands in the view so that the picture, turned about the vertical by `rotation`, finds its
// place.
glm::dmat3 view_to_environment(double rotation) {
    const double angle = rotation * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

}  // namespace

void EnvironmentAccumulator::set_environment(std::shared_ptr<const Environment> environment) {
    if (environment == environment_) return;
    environment_ = std::move(environment);
    const LatLong& picture = environment_->picture;
    picture_.store({picture.width, picture.height}, GL_RGB32F, GL_RGB, GL_FLOAT, picture.radiance.data(),
                   GL_NEAREST);
    store_order(light_order_, environment_->light);
}

void EnvironmentAccumulator::set_facets(const std::shared_ptr<const Tables>& tables) {
    if (tables == facets_of_) return;
    facets_of_ = tables;
    const int side = tables->quality == Quality::draft ? draft_side : final_side;
    store_order(facet_order_, order_facets(*tables->distribution, side));
}

void EnvironmentAccumulator::restart(glm::ivec2 texels) {
    texels_ = texels;
    samples_ = batch_ = row_ = 0;
    target_.bind(texels, GL_RGBA32F);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
}

double EnvironmentAccumulator::add(const Program& program, const GeometryBuffer& geometry, const Scene& scene,
                                   double most, int goal) {
    if (samples_ >= goal) return 0;
    const double a_row = texels_.x, whole = a_row * texels_.y;
    if (row_ == 0)
        batch_ = std::clamp(static_cast<int>(std::min(most / whole, 1e6)), 1,
                            std::min(batch_max, goal - samples_));
    const int rows =
        std::clamp(static_cast<int>(std::min(most / (a_row * batch_), 1e6)), 1, texels_.y - row_);
    geometry.normals().bind(1);
    geometry.tangents().bind(2);
    facet_order_.bind(4);
    light_order_.bind(5);
    set_uniform(program, "normals", 1);
    set_uniform(program, "tangents", 2);
    set_uniform(program, "facet_order", 4);
    set_uniform(program, "light_order", 5);
    const double brightness = environment_->brightness;
    set_uniform(program, "light_scale", brightness > 0 ? 1 / (3 * brightness) : 0.0);
    set_uniform(program, "first_sample", samples_);
    set_uniform(program, "samples", batch_);
    upload_environment(program, scene, 3);
    target_.bind(texels_, GL_RGBA32F);
    full_screen_.add(row_, rows);
    row_ += rows;
    if (row_ == texels_.y) {
        samples_ += batch_;
        row_ = 0;
    }
    return a_row * rows * batch_;
}

void EnvironmentAccumulator::upload_environment(const Program& program, const Scene& scene, int unit) const {
    picture_.bind(unit);
    set_uniform(program, "environment_picture", unit);
    set_uniform(program, "view_to_environment", view_to_environment(scene.environment.rotation));
    set_uniform(program, "environment_brightness", scene.environment.brightness);
}

}  // namespace nacre
