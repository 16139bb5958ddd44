// Windows bitmaps: what the header says of sizes, bits and colours must fit, and the file must have the rows.
// (Microsoft, "Bitmap Header Types")
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t oldest = 12, with_alpha_mask = 56;  // bytes of a header

enum Compression : std::uint64_t { none, runs_of_8_bits, runs_of_4_bits, masks, masks_with_alpha = 6 };

bool is_known_kind(std::uint64_t bits, std::uint64_t compression) {
    if (compression == runs_of_8_bits) return bits == 8;
    if (compression == runs_of_4_bits) return bits == 4;
    if (compression == masks || compression == masks_with_alpha) return bits == 16 || bits == 32;
    return compression == none &&
           (bits == 1 || bits == 4 || bits == 8 || bits == 16 || bits == 24 || bits == 32);
}

}  // namespace

void examine_bmp(const FileBytes& file, Examined& found) {
    const std::string header = file.read(0, 70);
    const std::uint64_t length = little_endian(header, 14, 4);
    const bool is_oldest = length == oldest;
    const std::size_t size = is_oldest ? 2 : 4;  // of a number
    const std::uint64_t width = little_endian(header, 18, size);
    const std::uint64_t lines = little_endian(header, 18 + size, size);
    // Below 0 where the lines are stored from the top.
    const auto height = static_cast<std::uint64_t>(
        std::abs(std::int64_t{static_cast<std::int32_t>(static_cast<std::uint32_t>(lines))}));
    const std::uint64_t bits = little_endian(header, 20 + 2 * size, 2);
    const std::uint64_t compression = is_oldest ? 0 : little_endian(header, 30, 4);
    const std::uint64_t colours = is_oldest ? 0 : little_endian(header, 46, 4);
    constexpr std::uint64_t lengths[] = {oldest, 40, 52, with_alpha_mask, 108, 124};
    if (std::find(std::begin(lengths), std::end(lengths), length) == std::end(lengths))
        throw PictureProblem(fmt::format("a BMP file with a header of {} bytes, which is not read", length));
    if (width < 1 || width > INT32_MAX || height < 1)
        throw PictureProblem("the BMP file's picture has no size");
    if (!is_known_kind(bits, compression))
        throw PictureProblem(
            fmt::format("a BMP file of {} bits a pixel, compressed by method {}", bits, compression));
    if (bits <= 8 && colours > (std::uint64_t{1} << bits))
        throw PictureProblem(
            fmt::format("a BMP file of {} bits a pixel with a palette of {} colours", bits, colours));
    found.size = glm::dvec2(width, height);
    found.has_runs = compression == runs_of_8_bits || compression == runs_of_4_bits;
    found.has_no_alpha = length < with_alpha_mask || little_endian(header, 66, 4) == 0;
    const std::uint64_t row = (width * bits + 31) / 32 * 4, start = little_endian(header, 10, 4);
    if (!found.has_runs && (start > file.size() || height > (file.size() - start) / row))
        throw PictureProblem("the BMP file is cut short");
}

}  // namespace nacre
