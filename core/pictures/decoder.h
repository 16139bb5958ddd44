// Decoding of pictures: all pixels are read through this interface.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/pictures/channels.h"

namespace nacre {

struct PictureLimits {
    int width = 0, height = 0;  // pixels, upright
    std::uintmax_t bytes = 0;   // of the file
};

// What is known of a picture before its pixels are.
struct PictureHeader {
    glm::ivec2 size{0, 0};  // as stored
    int orientation = 1;    // EXIF's
    int channels = 3;       // of colour
    bool encoded = false;   // integers in [0, 1]; else floats
    int bits = 0;           // of an integer
    bool has_alpha = false;
    bool associated = false;              // the colours have been multiplied by alpha already
    double gamma = 0;                     // of encoded colours; 0: sRGB's curve, 1: linear
    std::optional<glm::dmat3> to_rec709;  // of linear colours
    std::vector<std::string> notes;       // what was left out, or taken for something else
};

// Red, green, blue, alpha as they are stored, integers over their largest value. A grey is repeated, a
// missing blue 0, a missing alpha 1.
using PixelRow = std::span<const glm::vec4>;

class Decoder {
  public:
    virtual ~Decoder() = default;
    const PictureHeader& header() const { return header_; }
    // Every row once, from the top as stored. A PictureProblem where the decoder did not write all of them,
    // or a value is NaN or infinite.
    void read_rows(const std::function<void(int y, PixelRow row)>& take);

  protected:
    virtual void decode_rows(const std::function<void(int y, PixelRow row)>& take) = 0;
    PictureHeader header_;
};

// Marks values that the decoder has not written: a NaN that no file contains.
float unwritten();

// A PictureProblem where the file is no picture, is larger than the limits, or has no channels for the use.
// What the file claims to hold is compared with its size and the limits before memory is taken.
std::unique_ptr<Decoder> open_picture(const std::filesystem::path& file, const PictureLimits& limits,
                                      PictureUse use);

}  // namespace nacre
