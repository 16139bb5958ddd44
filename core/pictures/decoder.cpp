#include "core/pictures/decoder.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/pictures/decoders.h"
#include "core/pictures/orientation.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

// Decoders of these may take memory for all pixels at once, and a small file may truly hold many that are
// alike. Past what a picture other than an environment may have, they must show that they have something to
// decode: PNG by what deflate can hold, 1032 bytes in one, of 1 bit a pixel.
void check_claim(const OpenedFile& file) {
    constexpr std::array<std::pair<std::string_view, double>, 7> pixels_a_byte{{{"webp", 4096},
                                                                                {"jpeg2000", 4096},
                                                                                {"heif", 4096},
                                                                                {"targa", 4096},
                                                                                {"bmp", 4096},
                                                                                {"jpeg", 4096},
                                                                                {"png", 8 * 1032}}};
    constexpr double doubtful = 4096.0 * 4096.0;
    const glm::dvec2 size = file.examined.size;
    const auto bytes = static_cast<double>(file.bytes->size());
    for (const auto& [format, most] : pixels_a_byte)
        if (format == file.examined.format && size.x * size.y > std::max(doubtful, most * bytes))
            throw PictureProblem(
                fmt::format("{} x {} pixels in a file of {} bytes", size.x, size.y, file.bytes->size()));
}

}  // namespace

float unwritten() { return std::bit_cast<float>(0x7FC5A5A5u); }

void Decoder::read_rows(const std::function<void(int y, PixelRow row)>& take) {
    int rows = 0;
    decode_rows([&](int y, PixelRow row) {
        if (y != rows++ || row.size() != static_cast<std::size_t>(header_.size.x))
            throw PictureProblem("the picture is damaged: rows are missing");
        for (std::size_t x = 0; x < row.size(); ++x)
            for (int c = 0; c < 4; ++c)
                if (!std::isfinite(row[x][c])) {
                    const glm::ivec2 at = upright_place({x, y}, header_.size, header_.orientation);
                    const bool is_written =
                        std::bit_cast<std::uint32_t>(row[x][c]) != std::bit_cast<std::uint32_t>(unwritten());
                    throw PictureProblem(
                        is_written
                            ? fmt::format("pixel ({}, {}) from the top left is {}, must be finite", at.x,
                                          at.y, row[x][c])
                            : fmt::format(
                                  "the picture is damaged: pixel ({}, {}) from the top left is missing", at.x,
                                  at.y));
                }
        take(y, row);
    });
    if (rows != header_.size.y) throw PictureProblem("the picture is damaged: rows are missing");
}

void check_size(glm::dvec2 stored, int orientation, const PictureLimits& limits) {
    if (orientation >= 5) std::swap(stored.x, stored.y);
    if (stored.x <= limits.width && stored.y <= limits.height) return;
    if (orientation == 0 && stored.y <= limits.width && stored.x <= limits.height) return;  // told later
    if (limits.width == limits.height)
        throw PictureProblem(
            fmt::format("{} x {} pixels, more than {} a side", stored.x, stored.y, limits.width));
    throw PictureProblem(
        fmt::format("{} x {} pixels, more than {} x {}", stored.x, stored.y, limits.width, limits.height));
}

std::unique_ptr<Decoder> open_picture(const std::filesystem::path& file, const PictureLimits& limits,
                                      PictureUse use) {
    OpenedFile opened{std::make_unique<FileBytes>(file, limits.bytes), {}, limits, use};
    opened.examined = examine(*opened.bytes);
    check_size(opened.examined.size, opened.examined.orientation, limits);
    check_claim(opened);
    if (opened.examined.format == "webp") return make_webp_decoder(std::move(opened));
    if (opened.examined.format == "svg") return make_svg_decoder(std::move(opened));
    if (opened.examined.format == "psd") return make_psd_decoder(std::move(opened));
    return make_oiio_decoder(std::move(opened));
}

}  // namespace nacre
