// Reference pictures in tests/golden/. A failure leaves the picture and the difference in golden/ of the
// build folder; scripts/update-golden takes the pictures of today as reference.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace nacre::test {

// How far a picture may be from its reference; values of 255.
struct GoldenRule {
    double worst = 255;    // of one value
    double mean = 255;     // over all values
    double noticed = 255;  // more is a pixel that differs,
    int pixels = 0;        // and as many may
};

// What breaks the rule; empty when nothing does. Both pictures have three values in [0, 1] a pixel.
std::string golden_fault(const GoldenRule& rule, const std::vector<float>& actual,
                         const std::vector<float>& expected);

// Checks the picture against the reference of that name, or makes it the reference.
void check_golden(const std::string& name, const GoldenRule& rule, glm::ivec2 size,
                  const std::vector<float>& rgb);

}  // namespace nacre::test
