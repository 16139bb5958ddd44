#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <glm/ext/vector_int2_sized.hpp>

#include "core/design/error.h"
#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/exr_header.h"
#include "core/pictures/picture_problem.h"
#include "core/pictures/primaries.h"

namespace nacre {
namespace {

// Pixels that are stored together: a tile, or so many lines by the compression.
glm::i64vec2 block_size(const ExrHeader& header) {
    constexpr std::array<std::int64_t, 10> lines{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
    if (header.compression >= lines.size())
        throw PictureProblem(
            fmt::format("the EXR file's compression is of an unknown kind, {}", header.compression));
    if (!header.tile) return {header.width(), std::min(lines[header.compression], header.height())};
    const auto [width, height] = *header.tile;
    if (width < 1 || height < 1) throw PictureProblem("the EXR file's tiles have no size");
    return {width, height};
}

// Of the picture in full size. Memory for one is taken before it is read.
std::uint64_t count_blocks(const FileBytes& file, const ExrHeader& header) {
    constexpr double doubtful = 1 << 26, bytes_a_byte = 4096;
    const glm::i64vec2 block = block_size(header);
    const double bytes =
        static_cast<double>(block.x) * static_cast<double>(block.y) * static_cast<double>(header.pixel_bytes);
    if (bytes > std::max(doubtful, bytes_a_byte * static_cast<double>(file.size())))
        throw PictureProblem(
            fmt::format("blocks of {} x {} pixels in a file of {} bytes", block.x, block.y, file.size()));
    const auto up = [](std::int64_t length, std::int64_t step) {
        return static_cast<std::uint64_t>((length + step - 1) / step);
    };
    return up(header.width(), block.x) * up(header.height(), block.y);
}

// The table says where each block stands. One that is missing would be left as the memory was.
void check_blocks(const FileBytes& file, std::uint64_t table, std::uint64_t count) {
    constexpr std::uint64_t entry = 8, step = 8192;
    std::uint64_t missing = 0;
    if ((file.size() - table) / entry < count) missing = count;
    for (std::uint64_t first = 0; missing < count && first < count; first += step) {
        const std::uint64_t entries = std::min(step, count - first);
        const std::string places = file.read(table + first * entry, entries * entry);
        for (std::size_t i = 0; i < entries; ++i) {
            const std::uint64_t place = little_endian(places, i * entry, entry);
            if (place < table + count * entry || place >= file.size()) ++missing;
        }
    }
    if (missing > 0)
        throw PictureProblem(
            fmt::format("{} of its {} blocks of pixels are missing: the EXR file is cut short or unfinished",
                        missing, count));
}

}  // namespace

void examine_exr(const FileBytes& file, Examined& found) {
    const ExrHeaders headers = read_exr_headers(file);
    const ExrHeader& first = headers.parts[0];
    if (headers.is_deep) throw PictureProblem("its pixels are deep, flat ones are read");
    if (!first.subsampled.empty())
        throw PictureProblem(
            one_line(fmt::format("its channels {} have fewer samples than pixels, as luminance "
                                 "and chroma have; R, G, B or Y are read",
                                 fmt::join(first.subsampled, ", ")),
                     300));
    if (first.is_cube) throw PictureProblem("a cube map, not a picture by latitude and longitude");
    check_blocks(file, headers.end, count_blocks(file, first));
    const auto& display = first.display_window;
    found.size = glm::dvec2(display[2] - display[0], display[3] - display[1]) + 1.0;
    found.pieces = headers.pieces;
    if (first.chromaticities) found.to_rec709 = to_rec709(*first.chromaticities);
    if (headers.parts.size() > 1)
        found.notes.push_back(one_line(
            fmt::format("the first of its {} parts is used, \"{}\"", headers.parts.size(), first.name), 100));
}

}  // namespace nacre
