#include "app/designer/thumbnails.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "app/preview/render.h"
#include "core/bake/bake.h"
#include "core/base/system/thread_priority.h"
#include "core/design/design_file.h"

namespace nacre {
namespace {

constexpr int niceness = 15;  // of the worker: what is edited is baked first
constexpr double zoom = 1.2;  // the sphere fills the picture

}  // namespace

Thumbnails::Thumbnails()
    : job_([](const std::filesystem::path& file, const std::stop_token& stop, const auto& publish) {
          set_niceness(niceness);
          publish(bake(load_design(file), {.quality = Quality::draft, .threads = 1}, stop));
      }) {}

void Thumbnails::follow(const std::vector<Preset>& presets) {
    if (baking_) {
        const auto baked = job_.poll();
        if (!baked) return;
        draw(*std::exchange(baking_, std::nullopt), baked->result.value_or(nullptr));
        return;
    }
    for (const Preset& preset : presets)
        if (!pictures_.contains(preset.file)) {
            baking_ = preset.file;
            job_.submit(preset.file);
            return;
        }
}

void Thumbnails::draw(const std::filesystem::path& file, std::shared_ptr<const Tables> tables) {
    std::unique_ptr<Texture>& picture = pictures_[file];
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

ImTextureID Thumbnails::texture(const std::filesystem::path& file) const {
    const auto found = pictures_.find(file);
    if (found == pictures_.end() || !found->second) return nullptr;
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(found->second->name()));
}

}  // namespace nacre
