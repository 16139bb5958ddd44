// Options that the verbs which draw have in common.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "app/cli/command.h"
#include "app/preview/scene.h"

namespace nacre::cli {

// --size WxH, pixels.
void add_size_option(Command& command, glm::ivec2& size, int smallest);

// --scene NAME, --light THETA,PHI, --exposure EV and --term NAME.
struct SceneOptions {
    std::string name = "single";
    std::vector<double> light;  // theta, phi; empty: the scene's own
    double exposure = 0;        // EV
    std::string term = "total";

    Scene scene() const;
};

void add_scene_options(Command& command, SceneOptions& options);

}  // namespace nacre::cli
