// OpenGL without a display.
#pragma once

#include <glm/vec2.hpp>
#include <memory>

namespace nacre {

// A current OpenGL 3.3 core context for as long as it lives, whose framebuffer 0 is RGBA8 of the asked
// size. One at a time in a thread.
class OffscreenContext {
  public:
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

  protected:
    OffscreenContext() = default;
};

// Throws std::runtime_error when this machine cannot. The one place that knows which library draws.
std::unique_ptr<OffscreenContext> make_offscreen_context(glm::ivec2 size);

}  // namespace nacre
