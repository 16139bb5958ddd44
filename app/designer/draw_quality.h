// How finely the preview is drawn: as fast as the pointer while something moves, as well as the machine
// can once it rests.
#pragma once

#include <glm/vec2.hpp>

namespace nacre {

struct DrawQuality {
    double divisor = 1;   // of the pixels in each direction: one texel stands for divisor x divisor of them
    int supersample = 1;  // samples a texel in each direction
    bool operator==(const DrawQuality&) const = default;
};

// What changes from frame to frame. With new tables each, their bake takes its part of the frame.
enum class Motion { none, scene, tables };

// `seconds_a_sample`: measured on this machine with this design; 0 where nothing is known yet.
DrawQuality choose_quality(double seconds_a_sample, glm::ivec2 pixels, Motion motion);

// The finest there is, whatever it takes.
inline constexpr DrawQuality best_quality{.divisor = 1, .supersample = 2};

}  // namespace nacre
