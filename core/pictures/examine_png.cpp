// A PNG file reduced to the chunks that make its pixels, IHDR, PLTE, tRNS, IDAT and IEND: libpng prints what
// it dislikes about the others. (PNG, 3rd edition, section 5)
#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t signature_size = 8;
constexpr std::uint64_t frame_size = 12;  // of a chunk around its data: length, name, checksum

std::uint64_t checksum(const FileBytes& file, std::uint64_t offset, std::uint64_t length) {
    constexpr std::uint64_t step = 1u << 20;
    uLong crc = crc32(0, nullptr, 0);
    for (const std::uint64_t end = offset + length; offset < end; offset += step) {
        const auto bytes = file.read(offset, std::min(step, end - offset));
        crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    }
    return crc;
}

bool makes_pixels(std::string_view name) {
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

void read_header(std::string_view name, std::string_view data, Examined& found) {
    constexpr std::size_t header_size = 13;
    if (name != "IHDR" || data.size() != header_size)
        throw PictureProblem("the PNG file does not start with its header");
    found.size = glm::dvec2(big_endian(data, 0, 4), big_endian(data, 4, 4));
    const auto depth = static_cast<unsigned char>(data[8]);
    const auto colour_type = static_cast<unsigned char>(data[9]);
    if (found.size.x < 1 || found.size.y < 1 || !is_known_kind(depth, colour_type, data.substr(10)))
        throw PictureProblem("the PNG file's header describes no picture");
}

// gAMA says the exponent that encoded, in 100000ths; sRGB and a colour profile stand before it. What is
// near 1/2.2 is an approximation of sRGB's curve. (section 11.3.2)
struct Encoding {
    bool is_named = false;
    double exponent = 0;
    double gamma() const {
        if (is_named || exponent <= 0 || std::abs(exponent - 0.45455) < 0.01) return 0;
        return 1 / exponent;
    }
};

}  // namespace

void examine_png(const FileBytes& file, Examined& found) {
    found.pieces.push_back({{}, 0, signature_size});
    found.orientation = 1;
    Encoding encoding;
    for (std::uint64_t position = signature_size;;) {
        const std::string head = file.read(position, 8);
        const std::uint64_t length = big_endian(head, 0, 4);
        if (file.size() < position + frame_size || file.size() - position - frame_size < length)
            throw PictureProblem("the PNG file is cut short");
        const std::string name = head.substr(4);
        if (checksum(file, position + 4, length + 4) != big_endian(file.read(position + 8 + length, 4), 0, 4))
            throw PictureProblem(fmt::format("the PNG file is damaged at byte {}", position));
        const auto data = [&] { return file.read(position + 8, std::min<std::uint64_t>(length, 1u << 16)); };
        if (position == signature_size) read_header(name, data(), found);
        if (name == "eXIf") found.orientation = std::max(1, exif_orientation(data()));
        if (name == "sRGB" || name == "iCCP") encoding.is_named = true;
        if (name == "gAMA") encoding.exponent = static_cast<double>(big_endian(data(), 0, 4)) / 1e5;
        if (name == "acTL") found.notes.emplace_back("an animation, of which the first picture is used");
        if (makes_pixels(name)) found.pieces.push_back({{}, position, length + frame_size});
        if (name == "IEND") break;
        position += length + frame_size;
    }
    found.gamma = encoding.gamma();
}

}  // namespace nacre
