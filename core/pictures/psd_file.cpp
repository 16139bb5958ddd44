#include "core/pictures/psd_file.h"

#include <fmt/core.h>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t header_size = 26, palette_size = std::uint64_t{3} * 256;

void read_header(const std::string& header, PsdFile& found) {
    const std::uint64_t version = big_endian(header, 4, 2), mode = big_endian(header, 24, 2);
    if (header.size() < header_size) throw PictureProblem("the PSD file is cut short");
    if (version != 1 && version != 2)
        throw PictureProblem(fmt::format("a PSD file of version {}, 1 and 2 are read", version));
    found.is_large = version == 2;
    found.channels = static_cast<unsigned>(big_endian(header, 12, 2));
    found.size = glm::dvec2(big_endian(header, 18, 4), big_endian(header, 14, 4));
    found.depth = static_cast<unsigned>(big_endian(header, 22, 2));
    if (mode > static_cast<unsigned>(PsdMode::cmyk))
        throw PictureProblem(fmt::format(
            "a PSD file of colour mode {}; bitmap, grey, indexed, RGB and CMYK, 0 to 4, are read", mode));
    found.mode = static_cast<PsdMode>(mode);
    const bool is_known = found.mode == PsdMode::bitmap ? found.depth == 1
                          : found.mode == PsdMode::indexed
                              ? found.depth == 8
                              : found.depth == 8 || found.depth == 16 || found.depth == 32;
    if (!is_known)
        throw PictureProblem(
            fmt::format("a PSD file of {} bits a channel in colour mode {}", found.depth, mode));
    if (found.size.x < 1 || found.size.y < 1) throw PictureProblem("the PSD file's picture has no pixels");
}

// What its resources say of the merged picture: whether there is one, and which of its colours is none.
void read_resources(const FileBytes& file, std::uint64_t position, std::uint64_t end, PsdFile& found) {
    constexpr std::uint64_t version_info = 1057, transparency_index = 1047;
    while (position + 12 <= end) {
        const std::string head = file.read(position, 7);
        if (!head.starts_with("8BIM")) return;
        const std::uint64_t name = (big_endian(head, 6, 1) + 2) / 2 * 2;
        const std::uint64_t length = big_endian(file.read(position + 6 + name, 4), 0, 4);
        const std::uint64_t data = position + 10 + name;
        const std::uint64_t kind = big_endian(head, 4, 2);
        if (kind == version_info && big_endian(file.read(data + 4, 1), 0, 1) == 0)
            throw PictureProblem(
                "the PSD file was saved without its merged picture; save it with maximised compatibility");
        if (kind == transparency_index && found.mode == PsdMode::indexed)
            found.transparent_index = static_cast<unsigned>(big_endian(file.read(data, 2), 0, 2));
        position = data + (length + 1) / 2 * 2;
    }
}

}  // namespace

PsdFile read_psd_file(const FileBytes& file) {
    PsdFile found;
    read_header(file.read(0, header_size), found);
    const auto after = [&](std::uint64_t position, std::size_t length_size) {
        const std::uint64_t length = big_endian(file.read(position, length_size), 0, length_size);
        if (position + length_size > file.size() || length > file.size() - position - length_size)
            throw PictureProblem("the PSD file is cut short");
        return position + length_size + length;
    };
    const std::uint64_t resources = after(header_size, 4);
    if (found.mode == PsdMode::indexed) {
        found.palette = file.read(header_size + 4, resources - header_size - 4);
        if (found.palette.size() != palette_size)
            throw PictureProblem(fmt::format("a PSD file with a palette of {} bytes, must be {}",
                                             found.palette.size(), palette_size));
    }
    const std::uint64_t layers = after(resources, 4);
    read_resources(file, resources + 4, layers, found);
    const std::size_t length_size = found.is_large ? 8 : 4;
    found.picture = after(layers, length_size);
    // A number of layers below 0 says that the first channel after the colours is the opacity.
    const bool has_layers = found.picture - layers > 2 * length_size;
    found.has_alpha = has_layers && found.mode != PsdMode::bitmap && found.mode != PsdMode::indexed &&
                      big_endian(file.read(layers + 2 * length_size, 1), 0, 1) >= 0x80;
    const unsigned needed = found.inks() + (found.has_alpha ? 1 : 0);
    if (found.channels < needed)
        throw PictureProblem(
            fmt::format("the PSD file has {} channels, its picture needs {}", found.channels, needed));
    return found;
}

void examine_psd(const FileBytes& file, Examined& found) {
    found.size = read_psd_file(file).size;
    found.orientation = 1;
}

}  // namespace nacre
