// The designer on a window that nobody sees, two frames old.
#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "app/headless/stage.h"

namespace nacre::test {

struct Rig {
    HeadlessDesigner stage;

    explicit Rig(int bake_threads = 1) : Rig(StageOptions{.bake_threads = bake_threads}) {}
    explicit Rig(glm::ivec2 size, int bake_threads = 1)
        : Rig(StageOptions{.size = size, .bake_threads = bake_threads}) {}
    explicit Rig(const StageOptions& options) : stage(options) {
        stage.frame();
        stage.frame();
    }

    void play(const std::string& text) { stage.play(parse_events(text, "test")); }

    // Frames until `done`; false after a quarter of a minute.
    template <class Done>
    bool frames_until(const Done& done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(15);
        while (!done() && std::chrono::steady_clock::now() < end) {
            play("frames 1");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return done();
    }

    Designer& designer() { return stage.designer(); }
    Document& document() { return designer().document; }
    std::vector<Layer>& layers() { return document().design.distribution.layers; }
    ui::CanvasState& canvas() { return designer().canvas.state; }
};

}  // namespace nacre::test
