// Windows bitmaps: runs of palette colours, and headers whose numbers do not fit each other.
#include <doctest/doctest.h>

#include "core/image/picture.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::string little(std::uint64_t value, int length) {
    std::string bytes;
    for (int i = 0; i < length; ++i) bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

struct Bmp {
    std::uint64_t bits = 24, compression = 0;
    std::string pixels, palette = {};
    std::uint64_t width = 2, height = 1, colours = 0, length = 40;

    std::string bytes() const {
        const std::string header = little(length, 4) + little(width, 4) + little(height, 4) + little(1, 2) +
                                   little(bits, 2) + little(compression, 4) + std::string(12, '\0') +
                                   little(colours, 4) + little(0, 4);
        return "BM" + little(0, 8) + little(14 + header.size() + palette.size(), 4) + header + palette +
               pixels;
    }
};

// Every colour from black to white.
std::string greys() {
    std::string palette;
    for (char i = 0; palette.size() < 1024; ++i) palette += std::string(3, i) + '\0';
    return palette;
}

struct Read {
    const TemporaryFolder folder;
    ColourPicture operator()(const Bmp& bmp) {
        write_all(folder / "a.bmp", bmp.bytes());
        return load_colours(folder / "a.bmp");
    }
    std::string refusal(const Bmp& bmp) {
        return user_error_of([&] { (*this)(bmp); });
    }
};

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE_BEGIN("bmp picture");

TEST_CASE("bmp picture: colours of a palette, one by one and in runs, grey ones too") {
    Read read;
    using Colours = std::vector<glm::vec3>;
    const Colours row(300, glm::vec3(1));
    const std::string plain(300, '\xFF'), runs("\xFF\xFF\x2D\xFF\0\1", 6);
    CHECK(read({.bits = 8, .pixels = plain, .palette = greys(), .width = 300}).colours == row);
    CHECK(read({.bits = 8, .compression = 1, .pixels = runs, .palette = greys(), .width = 300}).colours ==
          row);
    const std::string red_and_white = std::string("\0\0\xFF\0\xFF\xFF\xFF\0", 8);
    CHECK(read({.bits = 4,
                .compression = 2,
                .pixels = std::string("\2\1\0\1", 4),
                .palette = red_and_white,
                .colours = 2})
              .colours == Colours{glm::vec3(1, 0, 0), glm::vec3(1)});
}

TEST_CASE("bmp picture: numbers that do not fit each other are refused") {
    Read read;
    const std::string pixels(8, '\1');
    REQUIRE(read.refusal({.pixels = pixels}).empty());
    for (const std::uint64_t bits : {1u, 4u, 16u, 24u, 32u})
        CHECK(
            has(read.refusal({.bits = bits, .compression = 1, .pixels = pixels}), "compressed by method 1"));
    for (const std::uint64_t method : {4u, 5u, 7u, 11u})
        CHECK(has(read.refusal({.compression = method, .pixels = pixels}), "compressed by method"));
    CHECK(has(read.refusal({.bits = 7, .pixels = pixels}), "7 bits a pixel"));
    CHECK(has(read.refusal({.bits = 8, .pixels = pixels, .palette = greys(), .colours = 257}),
              "a palette of 257 colours"));
    CHECK(has(read.refusal({.pixels = pixels, .width = 0}), "no size"));
    CHECK(has(read.refusal({.pixels = pixels, .width = 0x80000000}), "no size"));
    CHECK(has(read.refusal({.pixels = pixels, .height = 2}), "cut short"));
    CHECK(has(read.refusal({.pixels = pixels, .height = 0x80000000}), "cut short"));
    CHECK(has(read.refusal({.pixels = pixels, .length = 64}), "a header of 64 bytes"));
}

TEST_SUITE_END();
