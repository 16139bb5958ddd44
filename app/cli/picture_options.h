// Options that the verbs which draw have in common.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/preview/scene.h"

namespace nacre::cli {

// --size WxH, pixels.
void add_size_option(Command& command, glm::ivec2& size, int smallest);

// --object NAME|FILE.obj, --scene NAME, --light THETA,PHI, --exposure EV and what stands around:
// --environment NAME|FILE, --rotation, --brightness, --backdrop and --samples; --term NAME. Under an
// environment no light shines that is not asked for.
struct SceneOptions {
    std::string object = "sphere";  // see make_object()
    std::string name;               // empty: "single"
    std::vector<double> light;      // theta, phi; empty: the scene's own
    double exposure = 0;            // EV
    std::string environment;        // empty: none
    double rotation = 0;            // degrees
    double brightness = 1;
    bool backdrop = false;
    int samples = 256;  // a pixel
    std::string term = "total";

    // Those that the object and the environment are read from.
    std::vector<std::filesystem::path> files() const;

    // Makes the object and the environment: what is wrong with their files is a UserError.
    Scene scene() const;
};

void add_scene_options(Command& command, SceneOptions& options);

}  // namespace nacre::cli
