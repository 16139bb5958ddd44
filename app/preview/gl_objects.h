// OpenGL objects that free themselves. All need a current 3.3 core context, also to be destroyed.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/gl/gl.h"

namespace nacre {

class Program {
  public:
    // Throws std::runtime_error with the driver's log: a shader of ours that does not compile is a defect.
    Program(const std::string& vertex, const std::string& fragment);
    ~Program() { glDeleteProgram(name_); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    GLuint name() const { return name_; }
    GLint uniform(const char* field) const { return glGetUniformLocation(name_, field); }

  private:
    GLuint name_;
};

class Texture {
  public:
    Texture() { glGenTextures(1, &name_); }
    ~Texture() { glDeleteTextures(1, &name_); }
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    GLuint name() const { return name_; }
    void bind(int unit) const;

    // Storage without mipmaps, sampled at texels or linearly.
    void store(glm::ivec2 size, GLint internal_format, GLenum format, GLenum type, const void* texels,
               GLint filter);

  private:
    GLuint name_ = 0;
};

// Textures that can be drawn into at once: a fragment shader's output at location i goes into the i-th.
class Target {
  public:
    explicit Target(std::size_t textures = 1) : textures_(textures) { glGenFramebuffers(1, &name_); }
    ~Target() { glDeleteFramebuffers(1, &name_); }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    // Makes the textures the given size and format if they are not, then binds them for drawing.
    void bind(glm::ivec2 size, GLint internal_format);
    const Texture& texture(std::size_t index = 0) const { return textures_[index]; }
    std::vector<float> read(std::size_t index = 0) const;  // RGBA, bottom row first

  private:
    GLuint name_ = 0;
    std::vector<Texture> textures_;
    glm::ivec2 size_{0};
    GLint internal_format_ = 0;
};

// Draws the triangle of full_screen.vert into what is bound.
class FullScreen {
  public:
    FullScreen() { glGenVertexArrays(1, &name_); }
    ~FullScreen() { glDeleteVertexArrays(1, &name_); }
    FullScreen(const FullScreen&) = delete;
    FullScreen& operator=(const FullScreen&) = delete;

    void draw() const;

  private:
    GLuint name_ = 0;
};

// A surface's data as the shaders' `fetch` reads it.
void store_data(Texture& texture, const std::vector<float>& data);

}  // namespace nacre
