// Photoshop files without their layers: what is read is the merged picture, which stands last. (Adobe
// Photoshop File Formats Specification)
#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t version_info = 1057;

// Whether the resources say that the file was saved without a merged picture.
bool lacks_picture(const FileBytes& file, std::uint64_t position, std::uint64_t end) {
    while (position + 12 <= end) {
        const std::string head = file.read(position, 262);
        if (!head.starts_with("8BIM")) return false;
        const std::uint64_t name = (big_endian(head, 6, 1) + 2) / 2 * 2;
        const std::uint64_t length = big_endian(file.read(position + 6 + name, 4), 0, 4);
        const std::uint64_t data = position + 10 + name;
        if (big_endian(head, 4, 2) == version_info) return big_endian(file.read(data + 4, 1), 0, 1) == 0;
        position = data + (length + 1) / 2 * 2;
    }
    return false;
}

std::string big_endian_bytes(std::uint64_t value, std::size_t length) {
    std::string bytes;
    while (length-- > 0) bytes += static_cast<char>(value >> (8 * length));
    return bytes;
}

// Layers that hold nothing. A number of them below 0 is all that says that the merged picture's fourth
// channel is its transparency.
std::string empty_layers(bool transparent, std::size_t length_size) {
    if (!transparent) return std::string(length_size, '\0');
    const std::string layer = big_endian_bytes(0xFFFF, 2) + std::string(18, '\0') + "8BIMnorm" +
                              std::string("\xFF\0\0\0", 4) + big_endian_bytes(12, 4) + std::string(12, '\0');
    const std::string info = big_endian_bytes(layer.size(), length_size) + layer + std::string(4, '\0');
    return big_endian_bytes(info.size(), length_size) + info;
}

}  // namespace

void examine_psd(const FileBytes& file, Examined& found) {
    constexpr std::uint64_t header_size = 26;
    const std::string header = file.read(0, header_size);
    const bool is_large = big_endian(header, 4, 2) == 2;
    found.size = glm::dvec2(big_endian(header, 18, 4), big_endian(header, 14, 4));
    found.orientation = 1;
    const auto after = [&](std::uint64_t position, std::size_t length_size) {
        const std::uint64_t length = big_endian(file.read(position, length_size), 0, length_size);
        if (position + length_size > file.size() || length > file.size() - position - length_size)
            throw PictureProblem("the PSD file is cut short");
        return position + length_size + length;
    };
    const std::uint64_t resources = after(header_size, 4);
    const std::uint64_t layers = after(resources, 4);
    if (lacks_picture(file, resources + 4, layers))
        throw PictureProblem(
            "the PSD file was saved without its merged picture; save it with maximised compatibility");
    const std::size_t length_size = is_large ? 8 : 4;
    const std::uint64_t picture = after(layers, length_size);
    const bool has_layers = picture - layers > 2 * length_size;
    const bool transparent = has_layers && big_endian(file.read(layers + 2 * length_size, 1), 0, 1) >= 0x80;
    found.pieces = {{{}, 0, resources},
                    {std::string(4, '\0') + empty_layers(transparent, length_size), 0, 0},
                    {{}, picture, file.size() - picture}};
}

}  // namespace nacre
