#include "app/headless/offscreen_context.h"

#include <GL/osmesa.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace nacre {
namespace {

class OsMesaContext final : public OffscreenContext {
  public:
    explicit OsMesaContext(glm::ivec2 size)
        : pixels_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
        static constexpr int attributes[] = {OSMESA_FORMAT,
                                             OSMESA_RGBA,
                                             OSMESA_DEPTH_BITS,
                                             0,
                                             OSMESA_PROFILE,
                                             OSMESA_CORE_PROFILE,
                                             OSMESA_CONTEXT_MAJOR_VERSION,
                                             3,
                                             OSMESA_CONTEXT_MINOR_VERSION,
                                             3,
                                             0};
        context_ = OSMesaCreateContextAttribs(attributes, nullptr);
        if (context_ == nullptr) throw std::runtime_error("OSMesa has no OpenGL 3.3 core");
        if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, size.x, size.y) != GL_TRUE) {
            OSMesaDestroyContext(context_);
            throw std::runtime_error("OSMesa cannot draw a picture of this size");
        }
    }
    ~OsMesaContext() override { OSMesaDestroyContext(context_); }

  private:
    std::vector<std::uint32_t> pixels_;  // OSMesa draws into the caller's memory
    OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_offscreen_context(glm::ivec2 size) {
    return std::make_unique<OsMesaContext>(size);
}

}  // namespace nacre
