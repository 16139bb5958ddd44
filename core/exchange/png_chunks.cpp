#include "core/exchange/png_chunks.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include "core/design/design.h"

namespace nacre {
namespace {

constexpr std::size_t signature_size = 8;
constexpr std::size_t frame_size = 12;  // of a chunk around its data: length, name, checksum

constexpr std::array<std::uint32_t, 256> checksum_table = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit) table[i] = (table[i] >> 1) ^ (table[i] & 1 ? 0xEDB88320u : 0u);
    }
    return table;
}();

// CRC-32 of ISO 3309, as PNG's annex D has it.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char byte : bytes)
        crc = checksum_table[(crc ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (crc >> 8);
    return ~crc;
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4)) value = (value << 8) | static_cast<unsigned char>(byte);
    return value;
}

bool is_essential(std::string_view name) {
    return name == "IHDR" || name == "PLTE" || name == "tRNS" || name == "IDAT" || name == "IEND";
}

// Section 11.2.1: the bit depths of each colour type, and the only methods there are.
bool is_known_kind(unsigned depth, unsigned colour_type, std::string_view methods) {
    const bool whole_bytes = depth == 8 || depth == 16;
    const bool packed = depth == 1 || depth == 2 || depth == 4;
    if (methods[0] != 0 || methods[1] != 0 || (methods[2] != 0 && methods[2] != 1)) return false;
    if (colour_type == 0) return packed || whole_bytes;
    if (colour_type == 3) return packed || depth == 8;
    return (colour_type == 2 || colour_type == 4 || colour_type == 6) && whole_bytes;
}

void check_header(std::string_view chunk) {
    constexpr std::size_t header_size = 13;
    if (chunk.substr(4, 4) != "IHDR" || chunk.size() != header_size + frame_size)
        throw std::runtime_error("the PNG file does not start with its header");
    const std::string_view data = chunk.substr(8, header_size);
    const std::uint32_t width = big_endian(data);
    const std::uint32_t height = big_endian(data.substr(4));
    if (width > limits::picture_max || height > limits::picture_max)
        throw std::runtime_error(
            fmt::format("{} x {} pixels, more than {} a side", width, height, limits::picture_max));
    const auto depth = static_cast<unsigned char>(data[8]);
    const auto colour_type = static_cast<unsigned char>(data[9]);
    if (width == 0 || height == 0 || !is_known_kind(depth, colour_type, data.substr(10)))
        throw std::runtime_error("the PNG file's header describes no picture");
}

}  // namespace

std::string essential_png(std::string_view file) {
    std::string kept(file.substr(0, signature_size));
    for (std::size_t position = signature_size;;) {
        const std::string_view rest = file.substr(std::min(position, file.size()));
        if (rest.size() < frame_size) throw std::runtime_error("the PNG file is cut short");
        const std::size_t length = big_endian(rest);
        if (rest.size() - frame_size < length) throw std::runtime_error("the PNG file is cut short");
        const std::string_view chunk = rest.substr(0, length + frame_size);
        const std::string_view name = chunk.substr(4, 4);
        if (checksum(chunk.substr(4, length + 4)) != big_endian(chunk.substr(length + 8)))
            throw std::runtime_error(fmt::format("the PNG file is damaged at byte {}", position));
        if (position == signature_size) check_header(chunk);
        if (is_essential(name)) kept += chunk;
        if (name == "IEND") return kept;
        position += chunk.size();
    }
}

}  // namespace nacre
