// Numbers as file formats store them; of bytes that are missing, 0.
#pragma once

#include <cstdint>
#include <string_view>

namespace nacre {

inline std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t length) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + length; ++i)
        value = (value << 8) | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
    return value;
}

inline std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t length) {
    std::uint64_t value = 0;
    for (std::size_t i = at + length; i-- > at;)
        value = (value << 8) | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
    return value;
}

}  // namespace nacre
