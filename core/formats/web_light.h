// Environments for the web page, in as few bytes as show them well.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/light/direction_order.h"
#include "core/light/environment.h"

namespace nacre {

// Directions that each of an order's ranges keeps; in place of order_leaf_size.
inline constexpr int web_leaf_size = 8;
inline constexpr int web_environment_width = 256;  // texels

// A 16-bit float as little-endian bytes.
void add_half(std::string& bytes, double value);

// Four 16-bit floats a texel, in rows of 256 texels: the order's ranges, then web_leaf_size directions of
// each.
std::string order_bytes(const DirectionOrder& order);

// Three 16-bit floats a texel.
std::string picture_bytes(const Environment& environment);

// Those that the page offers.
std::vector<std::shared_ptr<const Environment>> web_environments();

}  // namespace nacre
