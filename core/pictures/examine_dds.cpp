// DirectDraw surfaces: the decoder is shown the plainest header that says the same, and as many bytes of
// pixels as it stands for. It reads endlessly, past its own memory or by 0 where a header is of another kind.
// (Microsoft, "Programming Guide for DDS")
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "core/base/error.h"
#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t header_size = 128, header_size_dx10 = 20;
constexpr std::uint64_t alpha_flag = 0x1, alpha_only = 0x2, code_flag = 0x4, rgb = 0x40, luminance = 0x20000,
                        normal = 0x80000000;

// Blocks of 4 x 4 pixels.
struct BlockKind {
    std::string_view code;     // as the file names it
    std::uint64_t dxgi;        // of DX10; else 0
    std::string_view plainer;  // that the decoder is shown
    std::uint64_t bytes;       // of a block
    bool may_be_normals = false;
    bool is_associated = false;
};

// The colours of DXT2 and DXT4, alone, are multiplied by alpha: the decoder divides, by 0 too.
constexpr BlockKind block_kinds[] = {{"DXT1", 0, "DXT1", 8},        {"DXT2", 0, "DXT3", 16, false, true},
                                     {"DXT3", 0, "DXT3", 16},       {"DXT4", 0, "DXT5", 16, false, true},
                                     {"DXT5", 0, "DXT5", 16, true}, {"RXGB", 0, "RXGB", 16},
                                     {"ATI1", 0, "ATI1", 8},        {"BC4U", 0, "ATI1", 8},
                                     {"ATI2", 0, "ATI2", 16, true}, {"BC5U", 0, "ATI2", 16, true},
                                     {"DX10", 80, "ATI1", 8},       {"DX10", 83, "ATI2", 16, true},
                                     {"DX10", 95, "DX10", 16},      {"DX10", 96, "DX10", 16},
                                     {"DX10", 98, "DX10", 16}};

std::string number(std::uint64_t value) {
    std::string bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
    return bytes;
}

struct Surface {
    std::string header;  // with DX10's, where there is one
    std::uint64_t field(std::size_t at) const { return little_endian(header, at, 4); }
    std::uint64_t height() const { return field(12); }
    std::uint64_t width() const { return field(16); }
    std::uint64_t kind() const { return field(80); }
    std::uint64_t bits() const { return field(88); }
    std::uint64_t mask(std::size_t channel) const { return field(92 + 4 * channel); }
    std::string_view code() const { return std::string_view(header).substr(84, 4); }
};

// What a decoder needs to know: `format` is that of a pixel from its flags to its masks.
std::string plain_header(const Surface& surface, const std::string& format) {
    constexpr std::uint64_t needed = 0x1007, texture = 0x1000;
    return "DDS " + number(header_size - 4) + number(needed) + number(surface.height()) +
           number(surface.width()) + std::string(56, '\0') + number(32) + format + number(texture) +
           std::string(16, '\0');
}

void check_whole(const FileBytes& file, const Surface& surface, std::uint64_t bytes) {
    const std::uint64_t have = file.size() - surface.header.size();
    if (bytes > have)
        throw PictureProblem(fmt::format("the DDS file's {} x {} pixels need {} bytes, it has {}",
                                         surface.width(), surface.height(), bytes, have));
}

std::uint64_t examine_blocks(const Surface& surface, Examined& found) {
    const std::uint64_t dxgi = surface.code() == "DX10" ? surface.field(header_size) : 0;
    const auto* kind = std::find_if(std::begin(block_kinds), std::end(block_kinds), [&](const auto& known) {
        return known.code == surface.code() && known.dxgi == dxgi;
    });
    if (kind == std::end(block_kinds))
        throw PictureProblem(
            one_line(fmt::format("a DDS file of the kind \"{}\"{}; DXT1 to DXT5, BC4 to BC7 and plain 8 bit "
                                 "colours are read",
                                 surface.code(), dxgi > 0 ? fmt::format(" {}", dxgi) : ""),
                     200));
    found.is_associated = kind->is_associated;
    const std::uint64_t flags = code_flag | (kind->may_be_normals ? surface.kind() & normal : 0);
    std::string header =
        plain_header(surface, number(flags) + std::string(kind->plainer) + std::string(20, '\0'));
    if (kind->plainer == "DX10") header += number(dxgi) + std::string(16, '\0');
    found.pieces.push_back({header, 0, 0});
    return (surface.width() + 3) / 4 * ((surface.height() + 3) / 4) * kind->bytes;
}

// The bits of a channel: at least one, side by side, in the pixel and in no other channel.
void check_mask(std::uint64_t mask, std::uint64_t others, std::uint64_t bits) {
    const std::uint64_t run = mask == 0 ? 0 : mask >> std::countr_zero(mask);
    if (mask == 0 || (run & (run + 1)) != 0 || (mask >> bits) != 0 || (mask & others) != 0)
        throw PictureProblem(fmt::format(
            "a channel of the DDS file is the bits {:#x} of {}, must be some side by side of its own", mask,
            bits));
}

std::uint64_t examine_plain(const Surface& surface, Examined& found) {
    const std::uint64_t colour = surface.kind() & (rgb | luminance | alpha_only);
    const std::uint64_t bits = surface.bits();
    if (!std::has_single_bit(colour))
        throw PictureProblem("a DDS file of neither red, green and blue, nor luminance, nor alpha alone");
    if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
        throw PictureProblem(fmt::format("a DDS file of {} bits a pixel, 8, 16, 24 and 32 are read", bits));
    std::array<std::uint64_t, 4> masks{};
    constexpr std::size_t alpha = 3;
    const bool has_alpha =
        colour == alpha_only || ((surface.kind() & alpha_flag) != 0 && surface.mask(alpha) != 0);
    const std::size_t colours = colour == rgb ? 3 : colour == luminance ? 1 : 0;
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < masks.size(); ++i) {
        if (i >= colours && !(i == alpha && has_alpha)) continue;
        masks[i] = surface.mask(i);
        check_mask(masks[i], seen, bits);
        seen |= masks[i];
    }
    std::string format =
        number(colour | (has_alpha && colour != alpha_only ? alpha_flag : 0)) + number(0) + number(bits);
    for (const std::uint64_t mask : masks) format += number(mask);
    found.pieces.push_back({plain_header(surface, format), 0, 0});
    return surface.width() * surface.height() * (bits / 8);
}

}  // namespace

void examine_dds(const FileBytes& file, Examined& found) {
    constexpr std::uint64_t cube = 0x200, volume = 0x200000, side_max = 1u << 24;
    Surface surface{file.read(0, header_size)};
    std::size_t whole = header_size;
    if (surface.header.size() == whole && (surface.kind() & code_flag) != 0 && surface.code() == "DX10") {
        whole += header_size_dx10;
        surface.header = file.read(0, whole);
    }
    if (surface.header.size() != whole) throw PictureProblem("the DDS file is cut short");
    const bool has_blocks = (surface.kind() & code_flag) != 0;
    if (surface.field(4) != header_size - 4 || surface.field(76) != 32 || surface.width() < 1 ||
        surface.height() < 1 || surface.width() > side_max || surface.height() > side_max)
        throw PictureProblem("the DDS file's header describes no picture");
    if ((surface.field(112) & cube) != 0) throw PictureProblem("a cube map, not a lat-long picture");
    if ((surface.field(112) & volume) != 0 && surface.field(24) > 1)
        throw PictureProblem("a picture of several layers, flat ones are read");
    found.size = glm::dvec2(surface.width(), surface.height());
    const std::uint64_t bytes = has_blocks ? examine_blocks(surface, found) : examine_plain(surface, found);
    check_whole(file, surface, bytes);
    found.pieces.push_back({{}, surface.header.size(), bytes});
}

}  // namespace nacre
