#include "core/paint/colour_map.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

// Matt Zucker, https://www.shadertoy.com/view/WlfXRN (CC0): rising powers of t.
constexpr double powers[7][3] = {{0.0002189403691192265, 0.001651004631001012, -0.01948089843709184},
                                 {0.1065134194856116, 0.5639564367884091, 3.932712388889277},
                                 {11.60249308247187, -3.972853965665698, -15.9423941062914},
                                 {-41.70399613139459, 17.43639888205313, 44.35414519872813},
                                 {77.162935699427, -33.40235894210092, -81.80730925738993},
                                 {-71.31942824499214, 32.62606426397723, 73.20951985803202},
                                 {25.13112622477341, -12.24266895238567, -23.07032500287172}};

}  // namespace

glm::u8vec3 inferno(double t) {
    t = std::clamp(t, 0.0, 1.0);
    glm::u8vec3 colour;
    for (int channel = 0; channel < 3; ++channel) {
        double sum = 0;
        for (int power = 6; power >= 0; --power) sum = sum * t + powers[power][channel];
        colour[channel] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(sum, 0.0, 1.0)));
    }
    return colour;
}

}  // namespace nacre
