// Panels under simulated input: a Dear ImGui context without a renderer, and widgets found by name.
#pragma once

#include <doctest/doctest.h>
#include <imgui.h>

#include <functional>
#include <string>
#include <string_view>

#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/theme.h"

class PanelRig {
  public:
    explicit PanelRig(std::function<void()> panel) : panel_(std::move(panel)) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(800, 1200);
        io.DeltaTime = 1.0f / 60;
        nacre::ui::map_keys(io);
        nacre::ui::take_input_at_once(io);
        nacre::ui::apply_theme(1);
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        items_.emplace();
        frame();
        frame();
    }
    ~PanelRig() {
        items_.reset();
        ImGui::DestroyContext();
    }
    PanelRig(const PanelRig&) = delete;
    PanelRig& operator=(const PanelRig&) = delete;

    static constexpr int enter = nacre::ui::key::enter;
    static constexpr int escape = nacre::ui::key::escape;
    static constexpr int remove = nacre::ui::key::remove;

    void frame(int count = 1) {
        for (int i = 0; i < count; ++i) {
            items_->clear();
            ImGui::NewFrame();
            ImGui::SetNextWindowPos(ImVec2(0, 0));
            ImGui::SetNextWindowSize(ImVec2(330, 1200));
            ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
            panel_();
            ImGui::End();
            ImGui::Render();
        }
    }

    bool has(std::string_view name) const { return items_->rectangle(name).has_value(); }

    void move(std::string_view name, float x = 0.5f, float y = 0.5f) {
        frame();
        const auto box = items_->rectangle(name);
        REQUIRE_MESSAGE(box, name);
        ImGui::GetIO().MousePos = ImVec2(box->x + x * (box->z - box->x), box->y + y * (box->w - box->y));
        frame();
    }
    void button(bool down, int which = 0) {
        ImGui::GetIO().MouseDown[which] = down;
        frame();
    }
    void click(std::string_view name, float x = 0.5f, float y = 0.5f, int which = 0) {
        frame(30);  // else two clicks in a row count as a double click
        move(name, x, y);
        button(true, which);
        button(false, which);
        frame();
    }
    void double_click(std::string_view name, float x = 0.5f, float y = 0.5f) {
        click(name, x, y);
        button(true);
        button(false);
        frame();
    }
    void drag(std::string_view name, ImVec2 from, ImVec2 to) {
        frame(30);
        move(name, from.x, from.y);
        button(true);
        for (int i = 1; i <= 5; ++i) {
            const float t = static_cast<float>(i) / 5;
            move(name, from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
        }
        button(false);
        frame();
    }
    void key(int code, bool ctrl = false, bool shift = false) {
        ImGuiIO& io = ImGui::GetIO();
        nacre::ui::tell_key(io, code, true);
        nacre::ui::tell_modifiers(io, ctrl, shift, false);
        frame();
        nacre::ui::tell_key(io, code, false);
        hold();
        frame();
    }
    // Modifiers from the next frame on.
    void hold(bool ctrl = false, bool shift = false, bool alt = false) {
        nacre::ui::tell_modifiers(ImGui::GetIO(), ctrl, shift, alt);
    }
    void type(const char* text) {
        ImGui::GetIO().AddInputCharactersUTF8(text);
        frame();
    }
    // Ctrl+click on a number and a new one typed over it.
    void enter_number(std::string_view name, const char* text) {
        frame(30);
        move(name);
        hold(true);
        button(true);
        button(false);
        hold();
        key('A', true);
        type(text);
        key(enter);
        frame();
    }

    // An entry of a list.
    void choose(const std::string& list, const std::string& entry) {
        click(list);
        click(list + " " + entry);
        frame();
    }

  private:
    std::function<void()> panel_;
    std::optional<nacre::ui::ItemMap> items_;
};
