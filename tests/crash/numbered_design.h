// Designs that say which stroke they hold, so that what is found after a kill can be told from what was.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "core/design/design.h"

namespace nacre::test {

inline std::string stroke_name(int stroke) { return "stroke " + std::to_string(stroke); }

// 0 for a design of another name.
inline int stroke_of(const Design& design) {
    return design.name.starts_with("stroke ") ? std::stoi(design.name.substr(7)) : 0;
}

// Of every painted texel (FNV-1a).
inline std::uint64_t digest(const Design& design) {
    std::uint64_t hash = 14695981039346656037u;
    for (const Layer& layer : design.distribution.layers)
        if (const auto* painted = std::get_if<PaintedLobe>(&layer.lobe))
            for (const float value : painted->image.raster->values) {
                std::uint32_t bits = 0;
                std::memcpy(&bits, &value, sizeof bits);
                hash = (hash ^ bits) * 1099511628211u;
            }
    return hash;
}

}  // namespace nacre::test
