// How a painted layer's raster was made from a picture. The raster is what counts; the rest is kept so that
// it can be made again with other settings.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace nacre {

// How the numbers of a tangent-space normal map mean x (red), y (green) and z (blue). One decision for the
// whole map.
struct NormalReading {
    bool is_signed = false;     // the numbers as they are; else 0.5 is zero: 2 c - 1
    bool two_channels = false;  // blue is not read: z = sqrt(1 - x^2 - y^2)
    bool green_down = false;    // y points to the picture's lower edge, as DirectX has it; else up, as OpenGL

    bool operator==(const NormalReading&) const = default;
};

enum class SourceUse {
    stamp,    // its light is stamped in the middle, the way up that it shines
    normals,  // of a surface, as colours
    heights   // of a surface, as brightness
};
inline constexpr std::array<std::string_view, 3> source_uses{"stamp", "normals", "heights"};

struct PictureSource {
    std::filesystem::path image;  // absolute
    SourceUse as = SourceUse::stamp;
    double size = 30;       // degrees, of a stamp: from its middle to its edge
    NormalReading reading;  // of normals
    double height = 2;      // from black to white, in percent of the picture's width; negative: black is high
    double smoothing = 1.5;  // degrees, of normals and heights: the standard deviation of their angle
    double rotation = 0;     // degrees, counterclockwise
    bool flip = false;       // left and right, before it is rotated

    bool operator==(const PictureSource&) const = default;
};

}  // namespace nacre
