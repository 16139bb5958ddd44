// A Photoshop file without its layers: only the merged picture, which comes last, is read. (Adobe
// Photoshop File Formats Specification)
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "core/pictures/file_bytes.h"

namespace nacre {

enum class PsdMode : unsigned { bitmap = 0, grey = 1, indexed = 2, rgb = 3, cmyk = 4 };

struct PsdFile {
    bool is_large = false;  // PSB, whose lengths have more bytes
    unsigned channels = 0;  // stored
    glm::dvec2 size{0, 0};
    unsigned depth = 0;  // bits of a channel's pixel
    PsdMode mode = PsdMode::rgb;
    std::string palette;                        // of indexed colours: 256 reds, greens, blues
    std::optional<unsigned> transparent_index;  // the colour of the palette that is none
    bool has_alpha = false;                     // the channel after the colours is the picture's opacity
    std::uint64_t picture = 0;                  // where the merged picture begins

    // Channels that the picture is made of, without the opacity.
    unsigned inks() const { return mode == PsdMode::rgb ? 3 : mode == PsdMode::cmyk ? 4 : 1; }
};

// A PictureProblem where it is damaged or has no merged picture that is read.
PsdFile read_psd_file(const FileBytes& file);

}  // namespace nacre
