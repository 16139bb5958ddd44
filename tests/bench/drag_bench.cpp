// How long a frame takes while a slider of an anisotropic design is dragged: every frame asks for new
// tables. The same without any bake (exposure is dragged, which redraws the picture as often) tells
// what the bake adds. `stroke` is the time from an event of a brush to the end of the frame whose sphere
// shows it. On OSMesa, 1280 x 800; milliseconds.
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/gl/gl.h"
#include "app/headless/stage.h"

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr auto frame_time = std::chrono::microseconds(16667);

nacre::Design anisotropic_design() {
    nacre::Design design;
    design.distribution.layers[0].lobe = nacre::GaussianLobe{0.1, 1.0};
    design.diffuse = nacre::CoupledDiffuse{glm::dvec3(0.4, 0.05, 0.1)};
    return design;
}

struct Run {
    std::vector<double> frames;  // milliseconds, of a frame or of an event until it is seen
    int drafts = 0;              // tables that reached the screen
    int finals = 0;
};

// Holds the button for some seconds, sixty frames a second at the most: calls move(seconds since the
// beginning) before each frame and drawn(its beginning, run) after it, and counts the tables that it brought.
template <class Move, class Drawn>
Run hold_button(nacre::HeadlessDesigner& stage, double seconds, const Move& move, const Drawn& drawn) {
    Run run;
    auto shown = stage.designer().frame.tables;
    const auto begin = Clock::now();
    auto next = begin;
    while (Clock::now() - begin < std::chrono::duration<double>(seconds)) {
        const auto start = Clock::now();
        move(std::chrono::duration<double>(start - begin).count());
        stage.frame();
        glFinish();
        drawn(start, run);
        if (const auto& now = stage.designer().frame.tables; now != shown) {
            ++(now->quality == nacre::Quality::final ? run.finals : run.drafts);
            shown = now;
        }
        next = std::max(next + frame_time, Clock::now());
        std::this_thread::sleep_until(next);
    }
    ImGui::GetIO().MouseDown[0] = false;
    stage.frame();
    return run;
}

// Moves the pointer to and fro over a slider of a tab.
Run drag(nacre::HeadlessDesigner& stage, const std::string& tab, const std::string& slider, double seconds) {
    stage.play(nacre::parse_events("click \"" + tab + "\"", tab));
    stage.wait_for_bake();
    const ImVec4 box = stage.items().rectangle(slider).value();
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2((box.x + box.z) / 2, (box.y + box.w) / 2);
    stage.frame();
    io.MouseDown[0] = true;
    return hold_button(
        stage, seconds,
        [&](double t) {
            io.MousePos.x = box.x + (box.z - box.x) * static_cast<float>(0.5 + 0.4 * std::sin(3 * t));
        },
        [](Clock::time_point start, Run& run) {
            run.frames.push_back(Milliseconds(Clock::now() - start).count());
        });
}

// Paints. `frames` are the times from an event to the end of the first frame whose sphere shows it.
Run paint(nacre::HeadlessDesigner& stage, double seconds) {
    stage.play(nacre::parse_events("click \"Paint\"", "paint"));
    stage.wait_for_bake();
    const ImVec4 box = stage.items().rectangle("Canvas").value();
    const float radius = 0.3f * std::min(box.z - box.x, box.w - box.y);
    ImGuiIO& io = ImGui::GetIO();
    const nacre::BakeJob& baker = stage.designer().baker;
    std::vector<std::pair<std::uint64_t, Clock::time_point>> waiting;  // request, its event
    std::uint64_t before = 0;
    return hold_button(
        stage, seconds,
        [&](double seconds_since) {
            const auto t = static_cast<float>(seconds_since);
            io.MousePos = ImVec2((box.x + box.z) / 2 + radius * std::cos(1.3f * t) * std::cos(0.4f * t),
                                 (box.y + box.w) / 2 + radius * std::sin(1.3f * t));
            io.MouseDown[0] = t > 0.05f;
            before = baker.asked();
        },
        [&](Clock::time_point event, Run& run) {
            if (baker.asked() != before) waiting.emplace_back(baker.asked(), event);
            while (!waiting.empty() && waiting.front().first <= baker.answered()) {
                run.frames.push_back(Milliseconds(Clock::now() - waiting.front().second).count());
                waiting.erase(waiting.begin());
            }
        });
}

void print(const char* name, Run run) {
    std::sort(run.frames.begin(), run.frames.end());
    const auto at = [&](double share) {
        return run.frames[static_cast<std::size_t>(share * static_cast<double>(run.frames.size() - 1))];
    };
    std::printf("%-14s %6zu frames   median %6.2f   99 %% %6.2f   worst %6.2f   drafts %d   finals %d\n",
                name, run.frames.size(), at(0.5), at(0.99), run.frames.back(), run.drafts, run.finals);
}

void compare(double seconds) {
    nacre::HeadlessDesigner stage({});
    stage.designer().document = nacre::Document(anisotropic_design());
    stage.frame();
    stage.frame();
    print("without bake", drag(stage, "Light", "Exposure", seconds));
    print("with bake", drag(stage, "Layers", "Width x", seconds));
    print("stroke", paint(stage, seconds));
}

}  // namespace

int main(int count, char** values) {
    try {
        compare(count > 1 ? std::atof(values[1]) : 5);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nacre-drag-bench: %s\n", error.what());
        return 1;
    }
    return 0;
}
