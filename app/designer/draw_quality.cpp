#include "app/designer/draw_quality.h"

namespace nacre {
namespace {

// For the preview, of the 0.033 that a fluent frame has, ...
constexpr double scene_seconds = 0.015;
constexpr double tables_seconds = 0.006;  // ... of which a draft and the canvas take most
constexpr double resting_seconds = 0.04;  // a hitch that is not felt once nothing moves
constexpr double divisor_step = 0.5,
                 divisor_max = 3;  // a coarser picture no longer shows a narrow highlight

}  // namespace

DrawQuality choose_quality(double seconds_a_sample, glm::ivec2 pixels, Motion motion) {
    const double seconds = seconds_a_sample * pixels.x * pixels.y;
    if (motion == Motion::none)
        return {
            .divisor = 1,
            .supersample = seconds * best_quality.supersample * best_quality.supersample <= resting_seconds
                               ? best_quality.supersample
                               : 1};
    const double budget = motion == Motion::tables ? tables_seconds : scene_seconds;
    double divisor = 1;
    while (divisor < divisor_max && seconds / (divisor * divisor) > budget) divisor += divisor_step;
    return {.divisor = divisor, .supersample = 1};
}

}  // namespace nacre
