#include "app/designer/draw_quality.h"

namespace nacre {
namespace {

constexpr double moving_seconds = 0.015;  // for the preview, of the 0.033 that a fluent frame has
constexpr double resting_seconds = 0.04;  // a hitch that is not felt once nothing moves
constexpr int divisor_most = 3;           // a coarser picture no longer shows a narrow highlight

}  // namespace

DrawQuality choose_quality(double seconds_a_sample, glm::ivec2 pixels, bool moving) {
    const double seconds = seconds_a_sample * pixels.x * pixels.y;
    if (!moving)
        return {
            .divisor = 1,
            .supersample = seconds * best_quality.supersample * best_quality.supersample <= resting_seconds
                               ? best_quality.supersample
                               : 1};
    int divisor = 1;
    while (divisor < divisor_most && seconds / (divisor * divisor) > moving_seconds) ++divisor;
    return {.divisor = divisor, .supersample = 1};
}

}  // namespace nacre
