#include "app/preview/geometry_buffer.h"

#include "app/preview/upload.h"
#include "shaders/shader_text.h"

namespace nacre {

GeometryBuffer::GeometryBuffer()
    : sphere_(std::string(shader_text("full_screen.vert")), std::string(shader_text("sphere.frag"))) {}

bool GeometryBuffer::update(const Scene& scene, glm::ivec2 size) {
    const View view{size, object_to_view(scene), pixels_per_unit(scene, size)};
    if (drawn_ == view) return false;
    drawn_.reset();
    target_.bind(size, GL_RGBA32F);
    glUseProgram(sphere_.name());
    set_uniform(sphere_, "target_size", glm::dvec2(size));
    set_uniform(sphere_, "texels_per_unit", view.pixels_per_unit);
    set_uniform(sphere_, "object_to_view", view.object_to_view);
    full_screen_.draw();
    drawn_ = view;
    return true;
}

SurfaceImage GeometryBuffer::read() const {
    if (!drawn_) return {};
    return {drawn_->size, drawn_->pixels_per_unit, target_.read(0), target_.read(1)};
}

}  // namespace nacre
