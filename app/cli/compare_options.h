// A design beside another model, as the command line asks for it.
#pragma once

#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/preview/render.h"
#include "core/base/system/interrupt.h"

namespace nacre::cli {

// --compare MODEL, --view, --divider, --amplify and --signed.
struct CompareOptions {
    std::string model;  // empty: nothing is compared; a name, or a .nacre file
    std::string view = "divider";
    double divider = 0.5;
    DifferenceLook look = {};
};

void add_compare_options(Command& command, CompareOptions& options);

struct ComparedImage {
    RenderedImage image;
    std::string summary;  // a line: how far the two are apart
};

// The other design where the model is a file.
std::optional<Design> design_beside(const CompareOptions& options);

// The picture that is asked for, of `design` from `file` and what design_beside() gave.
ComparedImage render_comparison(const CompareOptions& options, const Design& design, const std::string& file,
                                const std::optional<Design>& beside, const Scene& scene, glm::ivec2 size,
                                bool linear, int samples, const Interrupt& interrupt);

}  // namespace nacre::cli
