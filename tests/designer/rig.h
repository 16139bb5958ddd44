// The designer on a window that nobody sees, two frames old.
#pragma once

#include <string>
#include <vector>

#include "app/headless/stage.h"

namespace nacre::test {

struct Rig {
    Stage stage;

    explicit Rig(int bake_threads = 1)
        : stage({.size = {1280, 800}, .ui_scale = 1, .bake_threads = bake_threads}) {
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
