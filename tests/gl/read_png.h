// A picture back from its file, for comparing.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

namespace nacre::test {

// Three values a pixel in [0, 1], rows from the top; empty when the file has another size.
std::vector<float> read_png(const std::filesystem::path& file, glm::ivec2 size);

}  // namespace nacre::test
