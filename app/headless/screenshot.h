// A picture of the whole window's interface, made without a display.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "app/designer/document.h"
#include "app/headless/event_script.h"
#include "app/headless/stage.h"

namespace nacre {

struct ScreenshotOptions {
    std::optional<Document> document;  // none: a new one
    EventScript script;                // events to play first
    glm::ivec2 size{1280, 800};
    float ui_scale = 1;
};

struct Screenshot {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;  // rows from the top
};

// The picture of a stage that was just made; it stays as it was then.
Screenshot screenshot(const ScreenshotOptions& options, HeadlessDesigner& stage);

// What is wrong with the script is a UserError at its line; no OpenGL is a std::runtime_error.
Screenshot screenshot(const ScreenshotOptions& options);

}  // namespace nacre
