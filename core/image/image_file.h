// Pictures that are written: PNG to look at, EXR to compute with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

enum class ImageFormat { png, exr };

// By the file's extension; a UserError of `file` for any other than .png and .exr.
ImageFormat image_format(const std::filesystem::path& file);

// A picture's file as it lies on the disk. It is made whole before any of it is written.
using ImageBytes = std::vector<unsigned char>;

std::string_view text_of(const ImageBytes& bytes);

// Three values a pixel, rows from the top. A PNG holds them as bytes, [0, 1] sRGB; an EXR as they are,
// linear.
ImageBytes image_bytes(ImageFormat format, glm::ivec2 size, std::span<const float> rgb);

// Three or four bytes a pixel, rows from the top; a fourth is left out.
ImageBytes png_bytes(glm::ivec2 size, std::span<const std::uint8_t> pixels);

// float32, ZIP, scan lines, one part; values pixel by pixel.
ImageBytes exr_bytes(glm::ivec2 size, const std::vector<std::string>& channels,
                     std::span<const float> values);

// The same as a file, whole or not at all; the format is that of its name.
void write_image(const std::filesystem::path& file, glm::ivec2 size, std::span<const float> rgb);

}  // namespace nacre
