// Options that the verbs which draw have in common.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "app/cli/command.h"
#include "app/preview/scene.h"

namespace nacre::cli {

// --size WxH, pixels.
void add_size_option(Command& command, glm::ivec2& size, int smallest);

// --scene NAME, --light THETA,PHI, --exposure EV and what stands around: --environment NAME|FILE, --rotation,
// --brightness, --backdrop and --samples. Under an environment no light shines that is not asked for.
struct SceneOptions {
    std::string name;           // empty: "single"
    std::vector<double> light;  // theta, phi; empty: the scene's own
    double exposure = 0;        // EV
    std::string environment;    // empty: none
    double rotation = 0;        // degrees
    double brightness = 1;
    bool backdrop = false;
    int samples = 256;  // a pixel

    // Throws UserError where the environment is neither a name nor a picture that can be used.
    Scene scene() const;
};

void add_scene_options(Command& command, SceneOptions& options);

}  // namespace nacre::cli
