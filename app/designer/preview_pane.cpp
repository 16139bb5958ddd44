#include "app/designer/preview_pane.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <utility>

#include "app/designer/preview_mouse.h"
#include "app/gl/gl.h"
#include "app/preview/probe.h"
#include "ui/compare_overlay.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr double rest_seconds = 0.12;  // without a change until the picture is drawn finely

// Of an environment's light: seconds of a frame, and samples a pixel while something moves or for a
// screenshot.
constexpr double refine_seconds = 0.015;
constexpr int moving_samples = 64, screenshot_samples = 64;
constexpr double degrees_per_pixel = 0.4;  // of a drag that turns the environment

}  // namespace

RenderedImage PreviewPane::picture(const Scene& scene, glm::ivec2 size, bool linear) {
    stale_ = true;  // it is drawn where the pane's own picture was
    return picture_of(preview_, scene, size, linear);
}

void PreviewPane::show_side(int side, const std::optional<ComparedSurface>& surface) {
    compared_.show(side, surface);
    stale_ = true;
}

std::optional<glm::dvec3> PreviewPane::normal_at(const Scene& scene, glm::dvec2 pixel) {
    return half_vector(scene, preview_.surface(scene, {int(size_.x), int(size_.y)}), pixel);
}

std::optional<ui::BrushSurface> PreviewPane::point(const Scene& scene) {
    size_ = ImGui::GetContentRegionAvail();
    pointed_at_.reset();
    if (size_.x < 1 || size_.y < 1) return {};
    corner_ = ImGui::GetCursorScreenPos();
    if (look.view == ui::CompareView::divider && !look.alone)
        ui::divider_handle(look.divider, corner_, size_);
    constexpr ImGuiButtonFlags buttons = ImGuiButtonFlags_MouseButtonLeft |
                                         ImGuiButtonFlags_MouseButtonRight |
                                         ImGuiButtonFlags_MouseButtonMiddle;
    ImGui::InvisibleButton("Preview", size_, buttons);
    ui::note_surface("Preview");
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 pixel(io.MousePos.x - corner_.x, io.MousePos.y - corner_.y);
    // While the camera turns, what lies under the pointer is not read back in each frame.
    const bool turning = ImGui::IsItemActive() && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (ImGui::IsItemHovered() && !turning) pointed_at_ = normal_at(scene, pixel);
    if (io.KeyShift && !tool_works_) return {};
    return ui::BrushSurface{.surface = ui::Surface::sphere,
                            .hovered = ImGui::IsItemHovered(),
                            .active = ImGui::IsItemActive(),
                            .pointed_at = pointed_at_,
                            .pixel = pixel,
                            .normal = [this, &scene](glm::dvec2 at) { return normal_at(scene, at); }};
}

void PreviewPane::work(Scene& scene, bool taken) {
    if (size_.x < 1 || size_.y < 1) return;
    const ImGuiIO& io = ImGui::GetIO();
    // A drag that began as the tool's stays so, and one that began with the light moves the light.
    if (ImGui::IsItemActivated()) tool_works_ = taken && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (!ImGui::IsItemActive()) tool_works_ = false;
    if (ImGui::IsItemActive() && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        orbit(scene, {io.MouseDelta.x, io.MouseDelta.y});
    } else if (ImGui::IsItemActive() && !tool_works_ && lights_shine(scene)) {
        const glm::dvec2 pixel(io.MousePos.x - corner_.x, io.MousePos.y - corner_.y);
        move_light_to(scene, preview_.surface(scene, {int(size_.x), int(size_.y)}), pixel);
    } else if (ImGui::IsItemActive() && !tool_works_) {
        // What is reflected follows the pointer: it stands before the object.
        double& rotation = scene.environment.rotation;
        rotation = std::remainder(rotation - static_cast<double>(io.MouseDelta.x) * degrees_per_pixel, 360.0);
    }
    if (ImGui::IsItemHovered() && !tool_works_ && io.MouseWheel != 0)
        zoom(scene, static_cast<double>(io.MouseWheel));
}

void PreviewPane::draw(const std::shared_ptr<const Tables>& tables, const Scene& scene, const Veil& veil) {
    if (tables != shown_) {
        preview_.set(tables);
        shown_ = tables;
        stale_ = true;
    }
    if (size_.x < 1 || size_.y < 1 || preview_.empty()) return;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    redraw_if_needed(scene, {int(size_.x * scale.x), int(size_.y * scale.y)});
    compared_.paint(preview_, look, corner_, size_);
    if (veil.strength && lights_shine(scene)) draw_glow(scene, veil);
    draw_marks(scene);
    draw_progress();
}

void PreviewPane::draw_progress() const {
    const SampleProgress progress = compared_.progress(preview_, look);
    if (progress.goal == 0) return;
    const std::string text =
        fmt::format("environment {} of {}", std::min(progress.samples, progress.goal), progress.goal);
    const float margin = 0.7f * ImGui::GetFontSize();
    ImGui::GetWindowDrawList()->AddText(
        ImVec2(corner_.x + margin, corner_.y + size_.y - margin - ImGui::GetFontSize()),
        ImGui::GetColorU32(ui::palette::text_dim), text.c_str());
}

// The divider, the names of the sides and the scale of a factor.
void PreviewPane::draw_marks(const Scene& scene) {
    const bool difference = look.view == ui::CompareView::difference && !look.alone;
    if (look.alone)
        ui::side_labels(look.labels[static_cast<std::size_t>(*look.alone)], {}, corner_, size_);
    else if (look.view == ui::CompareView::divider)
        ui::draw_divider(look.divider, corner_, size_);
    if (look.view != ui::CompareView::off && !look.alone)
        ui::side_labels(look.labels[0], look.labels[1], corner_, size_);
    if (!is_factor(scene.term) || difference) return;
    const FactorScale scale = preview_.shown_scale();
    const ScaleEnds ends = ends_in_words(scene.term, scale);
    ui::scale_legend({.title = info(scene.term).label,
                      .low = ends.low,
                      .high = ends.high,
                      .colour =
                          [&](float t) {
                              const glm::u8vec3 c = colour_of(scale, static_cast<double>(t));
                              return IM_COL32(c.x, c.y, c.z, 255);
                          }},
                     corner_, size_);
}

void PreviewPane::draw_glow(const Scene& scene, const Veil& veil) {
    const Glow glow = glow_of(scene, preview_.surface(scene, {int(size_.x), int(size_.y)}), veil);
    glow_.store(glow.size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, glow.rgba.data(), GL_LINEAR);
    const glm::vec2 covered(glow.size * veil.texel);
    ImGui::GetWindowDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(glow_.name())), corner_,
        ImVec2(corner_.x + covered.x, corner_.y + covered.y));
}

void PreviewPane::redraw_if_needed(const Scene& scene, glm::ivec2 size) {
    const double now = ImGui::GetTime();
    const bool changed = stale_ || scene != drawn_scene_ || size != drawn_size_ || look.view != drawn_view_ ||
                         look.alone != drawn_alone_ || look.difference != drawn_difference_;
    if (changed) {
        changed_at_ = now;
        last_motion_ = stale_ ? Motion::tables : Motion::scene;
    }
    const bool moves = now - changed_at_ < rest_seconds || ImGui::IsAnyMouseDown();
    const Pace pace = insist_on_best_ ? Pace::insisting : moves ? Pace::moving : Pace::resting;
    const bool accumulates = uses_environment(scene);
    const double a_sample = seconds_a_sample_ + (accumulates ? preview_.seconds_a_sample() : 0);
    const DrawQuality quality =
        insist_on_best_ ? best_quality : choose_quality(a_sample, size, moves ? last_motion_ : Motion::none);
    // What has been accumulated is not thrown away for a finer quality.
    const bool finer = accumulates ? pace != drawn_pace_ : quality != drawn_quality_;
    if (changed || (finer && pace != Pace::moving))
        redraw(scene, size, quality, pace);
    else
        compared_.refine(preview_, refine_seconds, look);
}

void PreviewPane::redraw(const Scene& scene, glm::ivec2 size, DrawQuality quality, Pace pace) {
    const glm::ivec2 texels = glm::max(glm::ivec2(glm::dvec2(size) / quality.divisor), glm::ivec2(1));
    if (uses_environment(scene))
        accumulate(scene, texels, quality.supersample, pace);
    else
        measured_draw(scene, texels, quality.supersample);
    drawn_scene_ = scene;
    drawn_view_ = look.view;
    drawn_alone_ = look.alone;
    drawn_difference_ = look.difference;
    drawn_size_ = size;
    drawn_quality_ = quality;
    drawn_pace_ = pace;
    stale_ = false;
}

// What moves shows at once, with as many samples as there is time for; what rests is accumulated from now on,
// and the picture before it stays until then.
void PreviewPane::accumulate(const Scene& scene, glm::ivec2 texels, int supersample, Pace pace) {
    const int goal = pace == Pace::insisting ? screenshot_samples
                     : pace == Pace::moving  ? moving_samples
                                             : usual_samples;
    compared_.begin(preview_, scene, texels, supersample, goal, look);
    do {
        compared_.refine(preview_, refine_seconds, look);
    } while ((pace == Pace::moving && compared_.progress(preview_, look).samples == 0) ||
             (pace == Pace::insisting && accumulating()));
}

void PreviewPane::measured_draw(const Scene& scene, glm::ivec2 texels, int supersample) {
    const auto begin = std::chrono::steady_clock::now();
    compared_.draw(preview_, scene, texels, supersample, look);
    glFinish();  // the time that drawing takes decides how finely the next picture is drawn
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const double samples = double(texels.x) * texels.y * supersample * supersample;
    // A shader's first picture includes its compilation: the cheapest of late counts, slowly forgotten.
    const double measured = taken.count() / samples;
    seconds_a_sample_ = seconds_a_sample_ > 0 ? std::min(measured, seconds_a_sample_ * 1.05) : measured;
}

}  // namespace nacre
