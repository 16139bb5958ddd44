#include "app/headless/screenshot.h"

#include <algorithm>
#include <thread>

#include "app/headless/stage.h"
#include "core/design/design_file.h"
#include "core/exchange/input_file.h"

namespace nacre {

Screenshot screenshot(const ScreenshotOptions& options) {
    EventScript script;
    if (options.script) script = parse_events(read_text_file(*options.script), options.script->string());
    // Nobody waits for a frame here: the bake takes every core.
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    Stage stage({.size = options.size, .ui_scale = options.ui_scale, .bake_threads = threads});
    if (options.design) stage.designer().document = Document(load_design(*options.design), *options.design);
    // Dear ImGui hides a window that sizes itself in its first frame.
    stage.frame(false);
    stage.frame(false);
    stage.wait_for_bake();
    stage.play(script);
    stage.wait_for_bake();
    stage.designer().preview.insist_on_best();
    stage.designer().canvas.insist_on_best();
    stage.frame();
    return {.size = stage.size(), .rgba = stage.pixels()};
}

}  // namespace nacre
