#include "app/preview/gl_objects.h"

#include <algorithm>
#include <stdexcept>

namespace nacre {
namespace {

constexpr int data_width = 1024;  // of shaders/uniforms.glsl

class Shader {
  public:
    Shader(GLenum stage, const std::string& text) : name_(glCreateShader(stage)) {
        const char* source = text.c_str();
        glShaderSource(name_, 1, &source, nullptr);
        glCompileShader(name_);
        GLint compiled = 0;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
        if (compiled) return;
        std::string log(8192, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(name_, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        glDeleteShader(name_);
        throw std::runtime_error("a shader does not compile: " + log);
    }
    ~Shader() { glDeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint name() const { return name_; }

  private:
    GLuint name_;
};

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment) : name_(glCreateProgram()) {
    const Shader first(GL_VERTEX_SHADER, vertex), second(GL_FRAGMENT_SHADER, fragment);
    glAttachShader(name_, first.name());
    glAttachShader(name_, second.name());
    glLinkProgram(name_);
    glDetachShader(name_, first.name());
    glDetachShader(name_, second.name());
    GLint linked = 0;
    glGetProgramiv(name_, GL_LINK_STATUS, &linked);
    if (linked) return;
    std::string log(8192, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteProgram(name_);
    throw std::runtime_error("a shader does not link: " + log);
}

void Texture::store(glm::ivec2 size, GLint internal_format, GLenum format, GLenum type, const void* texels,
                    GLint filter) {
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, size.x, size.y, 0, format, type, texels);
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, name_);
}

void Target::bind(glm::ivec2 size, GLint internal_format) {
    if (size != size_ || internal_format != internal_format_) {
        for (Texture& texture : textures_)
            texture.store(size, internal_format, GL_RGBA, GL_FLOAT, nullptr, GL_LINEAR);
        size_ = size;
        internal_format_ = internal_format;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, name_);
    std::vector<GLenum> outputs;
    for (const Texture& texture : textures_) {
        outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs.size()));
        glFramebufferTexture2D(GL_FRAMEBUFFER, outputs.back(), GL_TEXTURE_2D, texture.name(), 0);
    }
    glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        size_ = {0, 0};  // tried again: it may have been for want of memory
        throw std::runtime_error("OpenGL cannot draw into a picture of this size");
    }
    glViewport(0, 0, size.x, size.y);
}

std::vector<float> Target::read(std::size_t index) const {
    std::vector<float> texels(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * 4);
    glBindFramebuffer(GL_FRAMEBUFFER, name_);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

void Renderbuffer::store(glm::ivec2 size, GLenum internal_format, int samples) {
    glBindRenderbuffer(GL_RENDERBUFFER, name_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal_format, size.x, size.y);
}

void FullScreen::draw() const {
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(name_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void FullScreen::add(int first, int rows) const {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, first, viewport[2], rows);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(name_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

void store_data(Texture& texture, const std::vector<float>& data) {
    const int rows = std::max(1, static_cast<int>((data.size() + data_width - 1) / data_width));
    std::vector<float> padded(data);
    padded.resize(static_cast<std::size_t>(rows) * data_width, 0);
    texture.store({data_width, rows}, GL_R32F, GL_RED, GL_FLOAT, padded.data(), GL_NEAREST);
}

}  // namespace nacre
