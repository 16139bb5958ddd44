// A design as a picture: the line Design -> Needs -> Tables -> Shader -> picture, walked at once.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "app/preview/preview.h"
#include "app/preview/scene.h"
#include "core/compare/comparison_model.h"
#include "core/compare/picture_difference.h"
#include "core/design/design.h"

namespace nacre {

struct RenderedImage {
    glm::ivec2 size{0};
    std::vector<float> rgb;  // top row first; sRGB in [0, 1], or linear radiance times exposure
};

// What the preview shows, with four texels a pixel.
RenderedImage picture_of(Preview& preview, const Scene& scene, glm::ivec2 size, bool linear);

// Four texels a pixel, and `samples` a pixel of an environment's light. Needs a current OpenGL 3.3 core
// context; throws what bake() throws.
RenderedImage render_design(const Design& design, const Scene& scene, glm::ivec2 size, bool linear,
                            std::stop_token stop = {}, const std::function<void(double)>& progress = {},
                            int samples = 256);

// The same of two surfaces under one scene, factors on one scale, and how far apart they are on the object.
struct RenderedPair {
    RenderedImage left, right;
    std::vector<float> left_radiance, right_radiance;  // RGB, top row first, without exposure
    DifferenceNumbers difference;
};
RenderedPair render_pair(const ComparedSurface& left, const ComparedSurface& right, const Scene& scene,
                         glm::ivec2 size, bool linear, int samples = 256);

}  // namespace nacre
