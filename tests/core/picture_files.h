// Small pictures for the tests, in every format: four coloured quarters, wide as two squares.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace nacre::test {

struct FloatImage {
    glm::ivec2 size;
    int channels;
    std::vector<float> values;
};

// Red, green / blue, white, as it shall be seen.
FloatImage quarters(glm::ivec2 size = {64, 32});

// Noise that does not compress, so that every part of a file is of use.
FloatImage noise(glm::ivec2 size, int channels = 3);

// As a camera stores it that was held so; `orientation` is EXIF's. (EXIF 2.3, tag 274)
FloatImage stored(const FloatImage& upright, int orientation);

// With OpenImageIO. `attributes` are integers, but for those with text.
struct ImageAttributes {
    std::vector<std::pair<std::string, int>> numbers = {};
    std::vector<std::pair<std::string, std::string>> texts = {};
    std::vector<std::string> channels = {};
    glm::ivec2 window_at{0, 0}, display{0, 0};  // of an EXR, where it has one
};
void write_picture(const std::filesystem::path& file, const FloatImage& image,
                   const ImageAttributes& attributes = {});

// Byte by byte, for what OpenImageIO does not write.
// The axes as "-Y" and "+X".
std::string hdr_file(const FloatImage& upright, const std::string& first, const std::string& second);
std::string targa_file(const FloatImage& upright, bool from_right, bool from_top, bool run_lengths);
std::string bmp_file(const FloatImage& upright, bool from_top);
std::string pfm_file(const FloatImage& upright);
std::string dds_file(const FloatImage& upright);
std::string psd_file(const FloatImage& upright);
// Without compression; with so many attributes that nobody needs.
std::string exr_file(const FloatImage& upright, int attributes);

// What an EXIF block with nothing but an orientation holds.
std::string exif_block(int orientation);
// A PNG with one more chunk after its header; a WebP with EXIF.
std::string with_png_chunk(const std::string& png, const std::string& name, const std::string& data);
std::string with_webp_exif(const std::string& webp, glm::ivec2 size, int orientation);

}  // namespace nacre::test
