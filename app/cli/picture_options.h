// Options that the verbs which draw have in common.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "app/cli/command.h"
#include "app/preview/scene.h"

namespace nacre::cli {

// --size WxH, pixels.
void add_size_option(Command& command, glm::ivec2& size, int smallest);

// --object NAME|FILE.obj, --scene NAME, --light THETA,PHI and --exposure EV.
struct SceneOptions {
    std::string object = "sphere";  // see make_object()
    std::string name = "single";
    std::vector<double> light;  // theta, phi; empty: the scene's own
    double exposure = 0;        // EV

    // Makes the object: what is wrong with its file is a UserError.
    Scene scene() const;
};

void add_scene_options(Command& command, SceneOptions& options);

}  // namespace nacre::cli
