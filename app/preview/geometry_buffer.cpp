#include "app/preview/geometry_buffer.h"

#include <algorithm>
#include <stdexcept>

#include "app/preview/upload.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

constexpr int samples_max = 8;  // of a texel's coverage

std::string text(const char* name) { return std::string(shader_text(name)); }

void attach(GLuint framebuffer, GLenum attachment, GLuint renderbuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

}  // namespace

GeometryBuffer::GeometryBuffer()
    : sphere_(text("full_screen.vert"), text("geometry.glsl") + text("sphere.frag")),
      mesh_(text("mesh.vert"), text("geometry.glsl") + text("mesh.frag")),
      outline_(text("mesh.vert"), text("outline.frag")),
      fill_(text("full_screen.vert"), text("fill.frag")) {}

bool GeometryBuffer::update(const Scene& scene, glm::ivec2 size) {
    const View view{scene.object.mesh, size, object_to_view(scene), pixels_per_unit(scene, size)};
    if (drawn_ == view) return false;
    drawn_.reset();
    if (view.mesh) {
        draw_mesh(view);
        draw_coverage(view);
        fill(view.size);
    } else {
        target_.bind(size, GL_RGBA32F);
        use(sphere_, view);
        full_screen_.draw();
    }
    drawn_ = view;
    return true;
}

void GeometryBuffer::use(const Program& program, const View& view) const {
    glUseProgram(program.name());
    set_uniform(program, "target_size", glm::dvec2(view.size));
    set_uniform(program, "texels_per_unit", view.pixels_per_unit);
    set_uniform(program, "object_to_view", view.object_to_view);
}

void GeometryBuffer::resize(glm::ivec2 size) {
    if (size == size_) return;
    GLint samples = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    depth_.store(size, GL_DEPTH_COMPONENT32F, 0);
    samples_.store(size, GL_R8, std::min(samples, samples_max));
    attach(many_samples_.name(), GL_COLOR_ATTACHMENT0, samples_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OpenGL cannot draw into a picture of this size");
    size_ = size;
}

void GeometryBuffer::draw_mesh(const View& view) {
    if (stored_ != view.mesh) triangles_.store(*view.mesh);
    stored_ = view.mesh;
    resize(view.size);
    middles_.bind(view.size, GL_RGBA32F);
    attach(middles_.name(), GL_DEPTH_ATTACHMENT, depth_.name());
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    use(mesh_, view);
    triangles_.draw();
    glDisable(GL_DEPTH_TEST);
}

void GeometryBuffer::draw_coverage(const View& view) {
    glBindFramebuffer(GL_FRAMEBUFFER, many_samples_.name());
    glClear(GL_COLOR_BUFFER_BIT);
    use(outline_, view);
    triangles_.draw();
    covered_.bind(view.size, GL_R8);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, many_samples_.name());
    glBlitFramebuffer(0, 0, view.size.x, view.size.y, 0, 0, view.size.x, view.size.y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

void GeometryBuffer::fill(glm::ivec2 size) {
    target_.bind(size, GL_RGBA32F);
    glUseProgram(fill_.name());
    middles_.texture(0).bind(0);
    middles_.texture(1).bind(1);
    covered_.texture().bind(2);
    set_uniform(fill_, "normals", 0);
    set_uniform(fill_, "tangents", 1);
    set_uniform(fill_, "coverage", 2);
    full_screen_.draw();
}

SurfaceImage GeometryBuffer::read() const {
    if (!drawn_) return {};
    return {drawn_->size, drawn_->pixels_per_unit, target_.read(0), target_.read(1)};
}

}  // namespace nacre
