// A picture of the whole window's interface, made without a display.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace nacre {

struct ScreenshotOptions {
    std::optional<std::filesystem::path> design;  // none: a new one
    std::optional<std::filesystem::path> script;  // events to play first, see event_script.h
    glm::ivec2 size{1280, 800};
    float ui_scale = 1;
};

struct Screenshot {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;  // rows from the top
};

// Whatever is wrong with the files is a UserError; no OpenGL is a std::runtime_error.
Screenshot screenshot(const ScreenshotOptions& options);

}  // namespace nacre
