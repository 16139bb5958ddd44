#include "app/headless/stage.h"

#include <imgui.h>

#include <algorithm>
#include <glm/common.hpp>

#include "app/gl/gl.h"
#include "core/base/error.h"
#include "core/model/polar_angles.h"
#include "ui/keys.h"

namespace nacre {

HeadlessDesigner::HeadlessDesigner(const StageOptions& options)
    : size_(options.size),
      context_(make_offscreen_context(options.size)),
      session_(options.ui_scale, options.pixels_a_unit) {
    ImGuiIO& io = ImGui::GetIO();
    const float pixels = options.pixels_a_unit;
    io.DisplaySize = ImVec2(static_cast<float>(size_.x) / pixels, static_cast<float>(size_.y) / pixels);
    io.DisplayFramebufferScale = ImVec2(pixels, pixels);
    io.DeltaTime = 1.0f / 60;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;  // panels are resizable as in the window
    ui::map_keys(io);
    ui::take_input_at_once(io);
    designer_ = std::make_unique<Designer>(DesignerOptions{.bake_threads = options.bake_threads,
                                                           .folders = options.folders,
                                                           .dialogs = options.dialogs,
                                                           .folder_opener = options.folder_opener,
                                                           .autosave_bytes = options.autosave_bytes,
                                                           .welcomes = options.welcomes});
}

void HeadlessDesigner::frame(bool rasterise) {
    items_.clear();
    session_.new_frame();
    designer_->focus.tell_pointer(ImGui::GetIO());
    ImGui::NewFrame();
    draw_frame(*designer_);
    ImGui::Render();
    if (rasterise) session_.draw(size_);
    ImGui::GetIO().MouseWheel = 0;
}

void HeadlessDesigner::play(const EventScript& script) {
    for (const Event& event : script.events) play(event, script.file);
}

void HeadlessDesigner::wait_for_bake() {
    do {
        frame(false);  // submits what the last input changed
    } while (!designer_->frame.settled);
    designer_->objects.wait();
    frame(false);  // an object that has been made is taken
    designer_->baker.wait();
    designer_->environment.wait();
    designer_->stamps.wait();
    designer_->pictures.wait();
    designer_->remake.wait();
    designer_->comparison.wait();
    frame(false);
}

void HeadlessDesigner::move_to(glm::vec2 pixel) {
    ImGui::GetIO().MousePos = ImVec2(pixel.x, pixel.y);
    frame(false);
}

void HeadlessDesigner::press(int button, bool down) {
    ImGui::GetIO().MouseDown[button] = down;
    frame(false);
}

glm::vec2 HeadlessDesigner::pixel_of(const Place& place, const std::string& file, int line) {
    if (place.widget.empty()) return place.at;
    frame(false);  // what the last event changed has moved the widgets
    const auto refuse = [&](const char* why) {
        throw UserError(file, "line " + std::to_string(line), why, place.widget);
    };
    const auto box = items_.rectangle(place.widget);
    if (!box) refuse("no widget of this name is on the screen");
    const glm::vec2 low(box->x, box->y), high(box->z, box->w);
    if (place.polar) {
        if (place.widget != "Canvas") refuse("only the canvas shows normals");
        const HemisphereView view(designer_->canvas.state.camera, high - low);
        return low + glm::vec2(view.pixel(polar_direction(place.at.x, place.at.y)));
    }
    const glm::vec2 inside = low + glm::clamp(place.at, 0.01f, 0.99f) * (high - low);
    if (!items_.is_in_sight(place.widget, {inside.x, inside.y}))
        refuse("the widget is out of sight: its panel must be scrolled to it first");
    return low + place.at * (high - low);
}

void HeadlessDesigner::play(const Event& event, const std::string& file) {
    ImGuiIO& io = ImGui::GetIO();
    if (const auto* move = std::get_if<events::Move>(&event.what)) {
        move_to(pixel_of(move->to, file, event.line));
    } else if (const auto* button = std::get_if<events::Button>(&event.what)) {
        press(button->button, button->down);
    } else if (const auto* click = std::get_if<events::Click>(&event.what)) {
        move_to(pixel_of(click->at, file, event.line));
        press(click->button, true);
        press(click->button, false);
    } else if (const auto* drag = std::get_if<events::Drag>(&event.what)) {
        const glm::vec2 from = pixel_of(drag->from, file, event.line);
        const glm::vec2 to = pixel_of(drag->to, file, event.line);
        const int steps = std::max(drag->frames, 1);
        move_to(from);
        press(ImGuiMouseButton_Left, true);
        for (int i = 1; i <= steps; ++i)
            move_to(from + (to - from) * (static_cast<float>(i) / static_cast<float>(steps)));
        press(ImGuiMouseButton_Left, false);
    } else if (const auto* wheel = std::get_if<events::Wheel>(&event.what)) {
        io.MouseWheel = wheel->notches;
        frame(false);
    } else if (const auto* key = std::get_if<events::Key>(&event.what)) {
        set_key(io, key->press, true);
        frame(false);
        set_key(io, key->press, false);
        frame(false);
    } else if (const auto* text = std::get_if<events::Text>(&event.what)) {
        io.AddInputCharactersUTF8(text->utf8.c_str());
        frame(false);
    } else if (const auto* frames = std::get_if<events::Frames>(&event.what)) {
        for (int i = 0; i < frames->count; ++i) frame(false);
    } else if (const auto* drop = std::get_if<events::Drop>(&event.what)) {
        take_file(*designer_, drop->file);
        frame(false);
        designer_->pictures.wait();
        frame(false);
        frame(false);
    } else if (std::holds_alternative<events::Focus>(event.what)) {
        notice_focus(*designer_);
        designer_->watch.wait();
        frame(false);
        frame(false);
    } else {
        wait_for_bake();
    }
}

std::vector<std::uint8_t> HeadlessDesigner::pixels() const {
    const std::size_t row = static_cast<std::size_t>(size_.x) * 4;
    const std::size_t rows = static_cast<std::size_t>(size_.y);
    std::vector<std::uint8_t> upward(row * rows);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
    std::vector<std::uint8_t> downward;
    downward.reserve(upward.size());
    for (std::size_t y = rows; y-- > 0;) {
        const auto begin = upward.begin() + static_cast<std::ptrdiff_t>(y * row);
        downward.insert(downward.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    }
    for (std::size_t i = 3; i < downward.size(); i += 4) downward[i] = 255;  // a window is opaque
    return downward;
}

}  // namespace nacre
