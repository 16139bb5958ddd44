#include "app/designer/thumbnails.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "app/preview/render.h"
#include "core/bake/bake.h"
#include "core/base/system/thread_priority.h"

namespace nacre {
namespace {

constexpr int niceness = 15;  // of the worker: what is edited is baked first
constexpr double zoom = 1.2;  // the sphere fills the picture

}  // namespace

Thumbnails::Thumbnails()
    : job_([](const Wanted& wanted, const std::stop_token& stop, const auto& publish) {
          set_niceness(niceness);
          publish(bake(wanted.design(), {.quality = Quality::draft, .threads = 1}, stop));
      }) {}

void Thumbnails::follow(const std::vector<Wanted>& wanted) {
    if (baking_) {
        const auto baked = job_.poll();
        if (!baked) return;
        draw(*std::exchange(baking_, std::nullopt), baked->result.value_or(nullptr));
    }
    std::erase_if(pictures_, [&](const auto& picture) {
        return std::ranges::find(wanted, picture.first, &Wanted::name) == wanted.end();
    });
    for (const Wanted& one : wanted)
        if (!pictures_.contains(one.name)) {
            baking_ = one.name;
            job_.submit(one);
            return;
        }
}

void Thumbnails::draw(const std::string& name, std::shared_ptr<const Tables> tables) {
    std::unique_ptr<Texture>& picture = pictures_[name];
    if (!tables) return;
    if (!preview_) preview_ = std::make_unique<Preview>();
    preview_->set(std::move(tables));
    Scene scene = scene_by_name("studio").value();
    scene.zoom = zoom;
    const RenderedImage image = picture_of(*preview_, scene, {side, side}, false);
    std::vector<std::uint8_t> bytes(image.rgb.size());
    std::transform(image.rgb.begin(), image.rgb.end(), bytes.begin(), [](float value) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
    });
    picture = std::make_unique<Texture>();
    picture->store(image.size, GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, bytes.data(), GL_LINEAR);
}

ImTextureID Thumbnails::texture(const std::string& name) const {
    const auto found = pictures_.find(name);
    if (found == pictures_.end() || !found->second) return nullptr;
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(found->second->name()));
}

}  // namespace nacre
