// JPEG files without the segments that make no pixels: their number and content costs nothing.
// (ITU-T T.81, annex B)
#include <fmt/core.h>

#include <algorithm>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

bool starts_frame(unsigned marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// JFIF and Adobe's say how the colours are coded; other applications' and comments do not.
bool makes_pixels(unsigned marker) {
    const bool is_application = marker >= 0xE0 && marker <= 0xEF;
    return marker == 0xE0 || marker == 0xEE || (!is_application && marker != 0xFE);
}

}  // namespace

void examine_jpeg(const FileBytes& file, Examined& found) {
    constexpr std::string_view exif_name{"Exif\0\0", 6};
    found.pieces.push_back({{}, 0, 2});
    for (std::uint64_t position = 2;;) {
        const std::string head = file.read(position, 16);
        const auto marker = static_cast<unsigned>(big_endian(head, 1, 1));
        if (head.size() < 4) throw PictureProblem("the JPEG file is cut short");
        if (head[0] != '\xFF')
            throw PictureProblem(fmt::format("the JPEG file is damaged at byte {}", position));
        if (marker == 0xFF) {  // filling
            ++position;
            continue;
        }
        const std::uint64_t length = 2 + big_endian(head, 2, 2);
        if (length > file.size() - position) throw PictureProblem("the JPEG file is cut short");
        if (starts_frame(marker)) found.size = glm::dvec2(big_endian(head, 7, 2), big_endian(head, 5, 2));
        if (marker == 0xE1 && found.orientation == 0) {
            const std::string data = file.read(position + 4, length - 4);
            if (data.starts_with(exif_name)) found.orientation = exif_orientation(data.substr(6));
        }
        if (makes_pixels(marker)) found.pieces.push_back({{}, position, length});
        position += length;
        if (marker == 0xDA) {
            found.pieces.push_back({{}, position, file.size() - position});
            break;
        }
    }
    found.orientation = std::max(found.orientation, 1);
}

int exif_orientation(std::string_view exif) {
    const bool is_little = exif.starts_with("II");
    if (!is_little && !exif.starts_with("MM")) return 0;
    const auto number = [&](std::size_t at, std::size_t length) {
        return is_little ? little_endian(exif, at, length) : big_endian(exif, at, length);
    };
    constexpr std::size_t entry_size = 12;
    const auto directory = static_cast<std::size_t>(number(4, 4));
    if (number(2, 2) != 42 || directory >= exif.size()) return 0;
    const auto entries = static_cast<std::size_t>(number(directory, 2));
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * entry_size;
        if (entry + entry_size > exif.size()) break;
        if (number(entry, 2) != 0x0112) continue;
        const auto orientation = number(entry + 8, number(entry + 2, 2) == 4 ? 4 : 2);
        return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 0;
    }
    return 0;
}

}  // namespace nacre
