// Truevision TGA, version 2.0: sizes, and that no pixel names a colour which the palette does not have, since
// the decoder looks colours up unchecked. It is not shown the extension area, whose texts it reads past their
// ends; what that says of the pixels is read here.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t header_size = 18;
constexpr std::size_t block = 1u << 16;

// Bytes of the file one after the other, in blocks.
class Stream {
  public:
    Stream(const FileBytes& file, std::uint64_t position) : file_(file), position_(position) {}

    // Little-endian; a PictureProblem where the file ends.
    std::uint64_t number(std::size_t bytes) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) value |= std::uint64_t{byte()} << (8 * i);
        return value;
    }

  private:
    unsigned char byte() {
        if (at_ == block_.size()) {
            block_ = file_.read(position_, block);
            position_ += block_.size();
            at_ = 0;
            if (block_.empty()) throw PictureProblem("the TGA file is cut short");
        }
        return static_cast<unsigned char>(block_[at_++]);
    }

    const FileBytes& file_;
    std::uint64_t position_;
    std::string block_;
    std::size_t at_ = 0;
};

struct Palette {
    std::uint64_t colours;
    std::size_t index_bytes;  // of a pixel
};

void check_index(std::uint64_t index, const Palette& palette) {
    if (index >= palette.colours)
        throw PictureProblem(
            fmt::format("a pixel has colour {}, its palette has {}", index, palette.colours));
}

void check_pixels(Stream& stream, std::uint64_t pixels, const Palette& palette, bool packed) {
    constexpr std::uint64_t repeats = 128;
    while (pixels > 0) {
        const std::uint64_t head = packed ? stream.number(1) : 0;
        const std::uint64_t count = packed ? std::min(pixels, (head & (repeats - 1)) + 1) : pixels;
        const std::uint64_t stored = (head & repeats) != 0 ? 1 : count;
        for (std::uint64_t i = 0; i < stored; ++i) check_index(stream.number(palette.index_bytes), palette);
        pixels -= count;
    }
}

void check_palette(const FileBytes& file, const std::string& header) {
    const std::uint64_t first = little_endian(header, 3, 2), colours = little_endian(header, 5, 2);
    const std::uint64_t bits = little_endian(header, 7, 1), depth = little_endian(header, 16, 1);
    if (little_endian(header, 1, 1) != 1 || colours == 0) throw PictureProblem("a TGA without its palette");
    if (first != 0) throw PictureProblem(fmt::format("a TGA whose palette begins at colour {}", first));
    if (bits != 15 && bits != 16 && bits != 24 && bits != 32)
        throw PictureProblem(fmt::format("a TGA with a palette of {} bits a colour", bits));
    const std::uint64_t identification = little_endian(header, 0, 1);
    Stream stream(file, header_size + identification + colours * ((bits + 7) / 8));
    const std::uint64_t pixels = little_endian(header, 12, 2) * little_endian(header, 14, 2);
    const bool packed = (little_endian(header, 2, 1) & 8) != 0;
    check_pixels(stream, pixels, {colours, static_cast<std::size_t>(depth / 8)}, packed);
}

// Bits a pixel of each kind.
void check_depth(std::uint64_t kind, std::uint64_t depth) {
    constexpr std::uint64_t palette = 1, colours = 2;
    const bool fits = kind == palette   ? depth == 8 || depth == 16
                      : kind == colours ? depth >= 15
                                        : depth == 8 || depth == 16;
    if (!fits)
        throw PictureProblem(fmt::format("a TGA of {} bits a pixel with {}", depth,
                                         kind == palette   ? "a palette"
                                         : kind == colours ? "colours"
                                                           : "greys"));
}

// The footer of a file of the second version.
void read_extension(const FileBytes& file, Examined& found) {
    constexpr std::uint64_t footer = 26, length = 495, multiplied = 4;
    const std::string end = file.size() > header_size + footer ? file.read(file.size() - footer, footer) : "";
    if (end.find("TRUEVISION-XFILE.") != 8) return;
    found.pieces = {{{}, 0, file.size() - footer}, {std::string(footer, '\0'), 0, 0}};
    const std::string extension = file.read(little_endian(end, 0, 4), length);
    if (extension.size() < length || little_endian(extension, 0, 2) < length) return;
    found.is_associated = little_endian(extension, 494, 1) == multiplied;
    const auto above = static_cast<double>(little_endian(extension, 478, 2));
    const auto below = static_cast<double>(little_endian(extension, 480, 2));
    // What is near 2.2 is an approximation of sRGB's curve.
    if (above > 0 && below > 0 && std::abs(above / below - 2.2) > 0.05) found.gamma = above / below;
}

}  // namespace

void examine_targa(const FileBytes& file, Examined& found) {
    const std::string header = file.read(0, header_size);
    const std::uint64_t kind = little_endian(header, 2, 1) & 7;
    found.size = glm::dvec2(little_endian(header, 12, 2), little_endian(header, 14, 2));
    found.has_no_alpha = (little_endian(header, 17, 1) & 15) == 0;
    check_depth(kind, little_endian(header, 16, 1));
    if (kind == 1) check_palette(file, header);
    read_extension(file, found);
}

}  // namespace nacre
