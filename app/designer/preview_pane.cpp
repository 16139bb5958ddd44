#include "app/designer/preview_pane.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <glm/common.hpp>
#include <utility>

#include "app/designer/preview_mouse.h"
#include "app/gl/gl.h"
#include "app/preview/probe.h"
#include "ui/item_map.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr int glow_divisor = 4;        // pixels a texel: the glow is soft
constexpr double rest_seconds = 0.12;  // without a change until the picture is drawn finely

void handle_mouse(Scene& scene, ImVec2 corner, ImVec2 size, bool left_is_taken) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 scale = io.DisplayFramebufferScale;
    if (ImGui::IsItemActive()) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
            if (left_is_taken) return;
            const glm::dvec2 pixel((io.MousePos.x - corner.x) * scale.x,
                                   (io.MousePos.y - corner.y) * scale.y);
            move_light_to(scene, pixel, {int(size.x * scale.x), int(size.y * scale.y)});
        } else {
            orbit(scene, {io.MouseDelta.x, io.MouseDelta.y});
        }
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) zoom(scene, static_cast<double>(io.MouseWheel));
}

}  // namespace

void PreviewPane::show(std::shared_ptr<const Tables> tables) {
    preview_.set(std::move(tables));
    stale_ = true;
}

RenderedImage PreviewPane::picture(const Scene& scene, glm::ivec2 size, bool linear) {
    stale_ = true;  // it is drawn where the pane's own picture was
    return picture_of(preview_, scene, size, linear);
}

void PreviewPane::draw(Scene& scene, const std::optional<glm::dvec3>& glow, double radius, const Tool& tool) {
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (size.x < 1 || size.y < 1) return;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("Preview", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    ui::note_item("Preview");
    const bool taken = work(scene, corner, size, tool);
    handle_mouse(scene, corner, size, taken);
    if (preview_.empty()) return;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    redraw_if_needed(scene, {int(size.x * scale.x), int(size.y * scale.y)});
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(preview_.texture()));
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    ImGui::GetWindowDrawList()->AddImage(texture, corner, end, ImVec2(0, 1), ImVec2(1, 0));
    if (glow) draw_glow(scene, *glow, radius, corner, size);
}

// What the pointer on the sphere means to the canvas's tool. Returns whether the left button is the tool's.
bool PreviewPane::work(const Scene& scene, ImVec2 corner, ImVec2 size, const Tool& tool) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto normal = [&](glm::dvec2 pixel) {
        return half_vector(scene, pixel, {int(size.x), int(size.y)});
    };
    const glm::dvec2 pixel(io.MousePos.x - corner.x, io.MousePos.y - corner.y);
    const bool hovered = ImGui::IsItemHovered();
    pointed_at_ = hovered ? normal(pixel) : std::nullopt;
    if (io.KeyShift && !tool_works_) return false;
    const bool taken = tool({.surface = ui::Surface::sphere,
                             .hovered = hovered,
                             .active = ImGui::IsItemActive(),
                             .pointed_at = pointed_at_,
                             .pixel = pixel,
                             .normal = normal});
    // A drag that began as the tool's stays so, and one that began with the light moves the light.
    if (ImGui::IsItemActivated()) tool_works_ = taken && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (!ImGui::IsItemActive()) tool_works_ = false;
    return tool_works_;
}

void PreviewPane::draw_glow(const Scene& scene, glm::dvec3 h, double radius, ImVec2 corner, ImVec2 size) {
    const Glow glow = glow_of(scene, {int(size.x), int(size.y)}, h, radius, glow_divisor);
    glow_.store(glow.size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, glow.rgba.data(), GL_LINEAR);
    const glm::vec2 covered(glow.size * glow_divisor);
    ImGui::GetWindowDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(glow_.name())), corner,
        ImVec2(corner.x + covered.x, corner.y + covered.y));
}

void PreviewPane::redraw_if_needed(const Scene& scene, glm::ivec2 size) {
    const double now = ImGui::GetTime();
    const bool changed = stale_ || scene != drawn_scene_ || size != drawn_size_;
    if (changed) {
        changed_at_ = now;
        last_motion_ = stale_ ? Motion::tables : Motion::scene;
    }
    const bool moving = now - changed_at_ < rest_seconds || ImGui::IsAnyMouseDown();
    const DrawQuality quality =
        insist_on_best_ ? best_quality
                        : choose_quality(seconds_a_sample_, size, moving ? last_motion_ : Motion::none);
    if (changed || (quality != drawn_quality_ && (insist_on_best_ || !moving))) redraw(scene, size, quality);
}

void PreviewPane::redraw(const Scene& scene, glm::ivec2 size, DrawQuality quality) {
    const glm::ivec2 texels = glm::max(glm::ivec2(glm::dvec2(size) / quality.divisor), glm::ivec2(1));
    const auto begin = std::chrono::steady_clock::now();
    preview_.draw(scene, texels, quality.supersample);
    glFinish();  // the time that drawing takes decides how finely the next picture is drawn
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const double samples = double(texels.x) * texels.y * quality.supersample * quality.supersample;
    // A shader's first picture includes its compilation: the cheapest of late counts, slowly forgotten.
    const double measured = taken.count() / samples;
    seconds_a_sample_ = seconds_a_sample_ > 0 ? std::min(measured, seconds_a_sample_ * 1.05) : measured;
    drawn_scene_ = scene;
    drawn_size_ = size;
    drawn_quality_ = quality;
    stale_ = false;
}

}  // namespace nacre
