// Options that the verbs which draw have in common.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "app/preview/scene.h"

namespace CLI {
class App;
}

namespace nacre::cli {

// --size WxH, pixels.
void add_size_option(CLI::App& command, glm::ivec2& size, int smallest);

// --scene NAME, --light THETA,PHI and --exposure EV.
struct SceneOptions {
    std::string name = "single";
    std::vector<double> light;  // theta, phi; empty: the scene's own
    double exposure = 0;        // EV

    Scene scene() const;
};

void add_scene_options(CLI::App& command, SceneOptions& options);

}  // namespace nacre::cli
