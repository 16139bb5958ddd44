// The designer on a window that nobody sees, two frames old.
#pragma once

#include <string>
#include <vector>

#include "app/headless/stage.h"

namespace nacre::test {

struct Rig {
    Stage stage;

    explicit Rig(int bake_threads = 1) : Rig(StageOptions{.bake_threads = bake_threads}) {}
    explicit Rig(glm::ivec2 size, int bake_threads = 1)
        : Rig(StageOptions{.size = size, .bake_threads = bake_threads}) {}
    explicit Rig(const StageOptions& options) : stage(options) {
        stage.frame();
        stage.frame();
    }

    void play(const std::string& text) { stage.play(parse_events(text, "test")); }
    Designer& designer() { return stage.designer(); }
    Document& document() { return designer().document; }
    std::vector<Layer>& layers() { return document().design.distribution.layers; }
    ui::CanvasState& canvas() { return designer().canvas.state; }
};

}  // namespace nacre::test
