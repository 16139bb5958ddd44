// Pictures that are written: PNG to look at, EXR to compute with.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace nacre {

enum class ImageFormat { png, exr };

// By the file's extension; a UserError of `file` for any other than .png and .exr.
ImageFormat image_format(const std::filesystem::path& file);

// Three values a pixel, rows from the top. A PNG holds them as bytes, [0, 1] sRGB; an EXR as they are,
// linear.
void write_image(const std::filesystem::path& file, glm::ivec2 size, std::span<const float> rgb);

// Three or four bytes a pixel, rows from the top; a fourth is left out.
void write_png(const std::filesystem::path& file, glm::ivec2 size, std::span<const std::uint8_t> pixels);

// float32, ZIP, scan lines, one part; values pixel by pixel.
void write_exr(const std::filesystem::path& file, glm::ivec2 size, const std::vector<std::string>& channels,
               std::span<const float> values);

}  // namespace nacre
