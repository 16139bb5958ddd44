// DirectDraw surfaces of each kind that is read, and those on whose headers a decoder would never end, or
// read what is not there.
#include <doctest/doctest.h>

#include <array>

#include "core/image/picture.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::string little(std::uint64_t value) {
    std::string bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
    return bytes;
}

constexpr std::uint64_t alpha = 1, alpha_only = 2, code = 4, rgb = 0x40, luminance = 0x20000;

struct Dds {
    std::uint64_t kind = rgb, bits = 24;
    std::array<std::uint64_t, 4> masks{0xFF0000, 0xFF00, 0xFF, 0};
    std::string pixels;
    std::string name = std::string(4, '\0');
    std::uint64_t width = 2, height = 1, flags = 0x1007, depth = 0, levels = 0;
    std::uint64_t capabilities = 0x1000, more = 0;

    std::string bytes() const {
        std::string found = "DDS " + little(124) + little(flags) + little(height) + little(width) +
                            little(0) + little(depth) + little(levels) + std::string(44, '\0') + little(32) +
                            little(kind) + name + little(bits);
        for (const std::uint64_t mask : masks) found += little(mask);
        return found + little(capabilities) + little(more) + std::string(12, '\0') + pixels;
    }
};

struct Read {
    const TemporaryFolder folder;

    ColourPicture operator()(const Dds& dds) {
        write_all(folder / "a.dds", dds.bytes());
        return load_colours(folder / "a.dds");
    }
    float light(const Dds& dds) {
        write_all(folder / "a.dds", dds.bytes());
        return load_picture(folder / "a.dds", "test.nacre", "here", PictureShape::any).values[0];
    }
    std::string refusal(const Dds& dds) {
        return user_error_of([&] { (*this)(dds); });
    }
};

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

const glm::vec3 red(1, 0, 0), white(1), black(0);
const std::string two_bgr("\0\0\xFF\xFF\xFF\xFF", 6);

}  // namespace

TEST_SUITE_BEGIN("dds picture");

TEST_CASE("dds picture: plain pixels of every width") {
    Read read;
    using Colours = std::vector<glm::vec3>;
    CHECK(read({.pixels = two_bgr}).colours == Colours{red, white});
    CHECK(read({.bits = 16, .masks = {0xF800, 0x7E0, 0x1F, 0}, .pixels = std::string("\0\xF8\xFF\xFF", 4)})
              .colours == Colours{red, white});
    CHECK(read({.bits = 32,
                .masks = {0x3FF00000, 0xFFC00, 0x3FF, 0},
                .pixels = std::string("\0\0\xF0\x3F\xFF\xFF\xFF\x3F", 8)})
              .colours == Colours{red, white});
    const ColourPicture grey =
        read({.kind = luminance, .bits = 8, .masks = {0xFF}, .pixels = std::string("\xFF\0", 2)});
    CHECK(grey.channels == 1);
    CHECK(grey.colours == Colours{white, black});
    CHECK(read({.kind = alpha_only, .bits = 8, .masks = {0, 0, 0, 0xFF}, .pixels = std::string("\xFF\0", 2)})
              .colours == Colours{white, black});
    CHECK(read.light({.kind = rgb | alpha,
                      .bits = 32,
                      .masks = {0xFF0000, 0xFF00, 0xFF, 0xFF000000},
                      .pixels = "\xFF\xFF\xFF\x80",
                      .width = 1}) == doctest::Approx(128 / 255.0));
    // An alpha of no bits is none; of no levels there is still the first.
    CHECK(read({.kind = rgb | alpha, .pixels = two_bgr}).colours == Colours{red, white});
    CHECK(read({.pixels = two_bgr, .flags = 0x21007, .levels = 0}).colours == Colours{red, white});
}

TEST_CASE("dds picture: blocks, with alpha that is 0 too") {
    Read read;
    // One block: its two colours red and white, each pixel the first.
    const std::string colours = std::string("\0\xF8\xFF\xFF", 4) + std::string(4, '\0');
    const Dds plain{.kind = code, .pixels = colours, .name = "DXT1", .width = 4, .height = 4};
    CHECK(read(plain).colours == std::vector<glm::vec3>(16, red));
    Dds multiplied = plain;
    for (const char* name : {"DXT2", "DXT4"}) {
        multiplied.name = name;
        multiplied.pixels = std::string(8, '\0') + colours;
        CHECK(read.light(multiplied) == 0);
        multiplied.pixels = std::string(8, '\xFF') + colours;
        CHECK(read.light(multiplied) == doctest::Approx(0.2126));
    }
    Dds newer = plain;
    newer.name = "DX10";
    newer.pixels = little(80) + std::string(16, '\0') + std::string(2, '\xFF') + std::string(6, '\0');
    CHECK(read(newer).colours == std::vector<glm::vec3>(16, white));
    newer.pixels.replace(0, 4, little(28));
    CHECK(has(read.refusal(newer), "of the kind \"DX10\" 28"));
}

TEST_CASE("dds picture: masks that no pixel can have are refused") {
    Read read;
    const auto refusal = [&](std::array<std::uint64_t, 4> masks, std::uint64_t kind = rgb) {
        return read.refusal({.kind = kind, .masks = masks, .pixels = two_bgr});
    };
    CHECK(has(refusal({0xFF0000, 0, 0xFF, 0}), "the bits 0x0 of 24"));
    CHECK(has(refusal({0, 0, 0, 0}, luminance), "the bits 0x0 of 24"));
    CHECK(has(refusal({0, 0, 0, 0}, alpha_only), "the bits 0x0 of 24"));
    CHECK(has(refusal({0xFF0000, 0xF0F, 0xF0, 0}), "the bits 0xf0f of 24"));
    CHECK(has(refusal({0xFF000000, 0xFF00, 0xFF, 0}), "the bits 0xff000000 of 24"));
    CHECK(has(refusal({0xFF0000, 0xFF00, 0xFF00, 0}), "the bits 0xff00 of 24"));
    CHECK(has(refusal({0xFF0000, 0xFF00, 0xFF, 0x80}, rgb | alpha), "the bits 0x80 of 24"));
    CHECK(has(refusal({0xFF0000, 0xFF00, 0xFF, 0}, alpha), "neither red, green and blue"));
    CHECK(has(refusal({0xFF0000, 0xFF00, 0xFF, 0}, rgb | luminance), "neither red, green and blue"));
    for (const std::uint64_t bits : {0u, 7u, 48u, 1024u, 0xFFFFFFFFu})
        CHECK(has(read.refusal({.bits = bits, .pixels = two_bgr}), "bits a pixel"));
}

TEST_CASE("dds picture: what the file does not hold, and what is not flat") {
    Read read;
    CHECK(has(read.refusal({.pixels = two_bgr.substr(1)}), "2 x 1 pixels need 6 bytes, it has 5"));
    CHECK(has(read.refusal({.pixels = two_bgr, .width = 0}), "describes no picture"));
    CHECK(has(read.refusal({.pixels = two_bgr, .width = 0xFFFFFFFF, .height = 0xFFFFFFFF}),
              "describes no picture"));
    CHECK(has(read.refusal({.kind = code, .pixels = std::string(8, ' '), .name = "DXT5"}),
              "need 16 bytes, it has 8"));
    CHECK(has(read.refusal({.kind = code, .pixels = "x", .name = "DX10"}), "cut short"));
    CHECK(has(read.refusal({.kind = code, .pixels = "x", .name = "DX\n\1"}), "of the kind"));
    CHECK(has(read.refusal({.pixels = two_bgr, .more = 0x200}), "a cube map"));
    CHECK(has(read.refusal({.pixels = two_bgr, .depth = 5, .capabilities = 0x1008, .more = 0x200000}),
              "several layers"));
    const std::string blocks = Dds{.kind = code, .pixels = std::string(16, ' '), .name = "DXT5"}.bytes();
    for (std::size_t length = 4; length < 128; ++length) {
        write_all(read.folder / "header.dds", blocks.substr(0, length));
        CHECK(has(user_error_of([&] { load_colours(read.folder / "header.dds"); }), "cut short"));
    }
}

TEST_SUITE_END();
