#include "app/headless/screenshot.h"

#include <algorithm>
#include <thread>

namespace nacre {

Screenshot screenshot(const ScreenshotOptions& options) {
    // Nobody waits for a frame here: the bake takes every core.
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    HeadlessDesigner stage({.size = options.size, .ui_scale = options.ui_scale, .bake_threads = threads});
    return screenshot(options, stage);
}

Screenshot screenshot(const ScreenshotOptions& options, HeadlessDesigner& stage) {
    if (options.document) stage.designer().document = *options.document;
    // Dear ImGui hides a window that sizes itself in its first frame.
    stage.frame(false);
    stage.frame(false);
    stage.wait_for_bake();
    stage.play(options.script);
    stage.wait_for_bake();
    stage.designer().preview.insist_on_best();
    stage.designer().canvas.insist_on_best();
    stage.frame();
    return {.size = stage.size(), .rgba = stage.pixels()};
}

}  // namespace nacre
