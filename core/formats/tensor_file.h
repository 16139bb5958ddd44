// The container of the measured materials of RGL (EPFL): named arrays, little-endian.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace nacre {

struct Tensor {
    std::string name;
    std::vector<std::size_t> shape;  // slowest first
    std::variant<std::vector<float>, std::vector<std::uint8_t>> values;
};

// The bytes of a file that holds them in this order. What powitacq, Mitsuba 3 and pbrt-v4 read: magic,
// version 1.0, a directory, and each array on a multiple of 8 bytes.
std::string tensor_file(std::span<const Tensor> tensors);

}  // namespace nacre
