// The merged picture of Photoshop files, in each of their kinds, and files whose numbers do not fit.
#include <doctest/doctest.h>

#include <bit>

#include "core/image/picture.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

std::string big(std::uint64_t value, int length) {
    std::string bytes;
    while (length-- > 0) bytes += static_cast<char>(value >> (8 * length));
    return bytes;
}

enum Mode { bitmap, grey, indexed, rgb, cmyk, lab = 9 };

// Two pixels, one above the other; `picture` begins with the number of its compression.
struct Psd {
    int mode = rgb, depth = 8, channels = 3;
    std::string picture;
    int version = 1, width = 1, height = 2;
    std::string palette = {}, resources = {}, layers = {};

    std::string bytes() const {
        return "8BPS" + big(static_cast<unsigned>(version), 2) + std::string(6, '\0') +
               big(static_cast<unsigned>(channels), 2) + big(static_cast<unsigned>(height), 4) +
               big(static_cast<unsigned>(width), 4) + big(static_cast<unsigned>(depth), 2) +
               big(static_cast<unsigned>(mode), 2) + big(palette.size(), 4) + palette +
               big(resources.size(), 4) + resources + big(layers.size(), version == 2 ? 8 : 4) + layers +
               picture;
    }
};

std::string resource(unsigned kind, const std::string& data) {
    return "8BIM" + big(kind, 2) + big(0, 2) + big(data.size(), 4) + data +
           std::string(data.size() % 2, '\0');
}

struct Read {
    const TemporaryFolder folder;

    ColourPicture data(const Psd& psd) {
        write_all(folder / "a.psd", psd.bytes());
        return load_colours(folder / "a.psd");
    }
    std::vector<float> light(const Psd& psd) {
        write_all(folder / "a.psd", psd.bytes());
        return load_picture(folder / "a.psd", "test.nacre", "here", PictureShape::any).values;
    }
    std::string refusal(const Psd& psd) {
        return user_error_of([&] { data(psd); });
    }
};

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

// What a layer count of -1 looks like.
const std::string transparent_layers = big(20, 4) + big(0xFFFF, 2) + std::string(18, '\0');

}  // namespace

TEST_SUITE_BEGIN("psd picture");

TEST_CASE("psd picture: every kind of colours, plain") {
    Read read;
    const auto pixels = [&](const Psd& psd) { return read.data(psd).colours; };
    const glm::vec3 red(1, 0, 0), white(1), black(0);
    using Colours = std::vector<glm::vec3>;
    CHECK(pixels({.picture = std::string("\0\0\xFF\xFF\0\xFF\0\xFF", 8)}) == Colours{red, white});
    // What other channels hold is a selection.
    CHECK(pixels({.channels = 4, .picture = std::string("\0\0\xFF\xFF\0\xFF\0\xFF\7\7", 10)}) ==
          Colours{red, white});
    const ColourPicture deep = read.data(
        {.mode = grey, .depth = 16, .channels = 1, .picture = std::string("\0\0\x80\0\xFF\xFF", 6)});
    CHECK(deep.channels == 1);
    CHECK(deep.colours[0].g == doctest::Approx(32768 / 65535.0));
    CHECK(deep.colours[1] == white);
    const ColourPicture real =
        read.data({.mode = grey,
                   .depth = 32,
                   .channels = 1,
                   .picture = big(0, 2) + big(std::bit_cast<std::uint32_t>(2.5f), 4) + big(0, 4)});
    CHECK(!real.encoded);
    CHECK(real.colours == Colours{glm::vec3(2.5f), black});
    CHECK(pixels({.mode = bitmap, .depth = 1, .channels = 1, .picture = std::string("\0\0\x80\x7F", 4)}) ==
          Colours{black, white});
    CHECK(
        pixels({.mode = cmyk, .channels = 4, .picture = std::string("\0\0\xFF\xFF\0\xFF\0\xFF\xFF\0", 10)}) ==
        Colours{red, black});
    std::string palette(768, '\0');
    palette[7] = '\xFF';
    CHECK(
        pixels({.mode = indexed, .channels = 1, .picture = std::string("\0\0\7\6", 4), .palette = palette}) ==
        Colours{red, black});
}

TEST_CASE("psd picture: rows in PackBits, large documents") {
    Read read;
    // 128 and then 2 bytes alike; a byte that means nothing, then three as they are.
    const std::string run("\x81\xFF\xFF\xFF", 4), literal("\x80\2\1\2\3", 5);
    Psd psd{.mode = grey, .channels = 1, .picture = big(1, 2) + big(4, 2) + run, .width = 130, .height = 1};
    CHECK(read.data(psd).colours == std::vector<glm::vec3>(130, glm::vec3(1)));
    psd.version = 2;
    psd.picture = big(1, 2) + big(4, 4) + run;
    CHECK(read.data(psd).colours == std::vector<glm::vec3>(130, glm::vec3(1)));
    psd = {.mode = grey, .channels = 1, .picture = big(1, 2) + big(5, 2) + literal, .width = 3, .height = 1};
    CHECK(read.data(psd).colours[2].r == doctest::Approx(3 / 255.0));
    // Rows that do not come to an end, have too much, or are of no length at all.
    for (const std::string& row : {run.substr(0, 2), literal.substr(0, 4), std::string("\x80\x80", 2),
                                   std::string("\3\1\2\3\4", 5), std::string("\xFD\1", 2), std::string()}) {
        psd.picture = big(1, 2) + big(row.size(), 2) + row;
        CHECK(has(read.refusal(psd), "damaged: row 1 of channel 1"));
    }
}

TEST_CASE("psd picture: the opacity of layers, and of a palette") {
    Read read;
    // A quarter of full grey, as it lies on white, and nothing.
    const std::string on_white("\0\0\xFF\xFF\xFF\xFF\xFF\xFF\x40\0", 10);
    Psd psd{.channels = 4, .picture = on_white, .layers = transparent_layers};
    CHECK(read.data(psd).colours == std::vector<glm::vec3>{glm::vec3(1), glm::vec3(0)});
    CHECK(read.light(psd)[0] == doctest::Approx(64 / 255.0));
    psd.picture = std::string("\0\0\xBF\xFF\xBF\xFF\xBF\xFF\x40\0", 10);  // black at a quarter
    CHECK(read.light(psd)[0] == 0);
    psd.channels = 3;
    CHECK(has(read.refusal(psd), "has 3 channels, its picture needs 4"));
    psd = {.mode = indexed,
           .channels = 1,
           .picture = std::string("\0\0\7\6", 4),
           .palette = std::string(768, '\xFF'),
           .resources = resource(1047, big(6, 2))};
    // As wide as high: black stands beside it.
    const std::vector<float> values = read.light(psd);
    CHECK(values[0] + values[1] == 1);
    CHECK(values[2] + values[3] == 0);
}

TEST_CASE("psd picture: numbers that do not fit each other are refused") {
    Read read;
    const std::string pixels(8, '\0');
    CHECK(has(read.refusal({.picture = pixels.substr(1)}), "cut short"));
    CHECK(has(read.refusal({.channels = 2, .picture = pixels}), "has 2 channels, its picture needs 3"));
    CHECK(has(
        read.refusal({.mode = indexed, .channels = 0, .picture = pixels, .palette = std::string(768, ' ')}),
        "has 0 channels"));
    CHECK(has(read.refusal({.mode = indexed, .channels = 1, .picture = pixels, .palette = "short"}),
              "a palette of 5 bytes, must be 768"));
    CHECK(has(read.refusal({.depth = 1, .picture = pixels}), "1 bits a channel in colour mode 3"));
    CHECK(has(read.refusal({.mode = bitmap, .depth = 32, .picture = pixels}), "32 bits a channel"));
    CHECK(has(read.refusal({.mode = indexed, .depth = 16, .picture = pixels}), "16 bits a channel"));
    CHECK(has(read.refusal({.mode = lab, .picture = pixels}), "colour mode 9"));
    CHECK(has(read.refusal({.picture = big(3, 2) + pixels}), "compressed by method 3"));
    CHECK(has(read.refusal({.picture = pixels, .version = 7}), "version 7"));
    CHECK(has(read.refusal({.picture = pixels, .height = 0}), "no pixels"));
    CHECK(has(read.refusal({.picture = pixels, .resources = resource(1057, std::string(8, '\0'))}),
              "without its merged picture"));
    // Rows that claim more than the file has.
    CHECK(has(
        read.refusal({.mode = grey, .channels = 1, .picture = big(1, 2) + big(1, 2) + big(0xFFFF, 2) + "x"}),
        "cut short"));
    std::string bytes = Psd{.picture = pixels}.bytes();
    bytes.replace(30, 4, "\xFF\xFF\xFF\xFF");
    write_all(read.folder / "resources.psd", bytes);
    CHECK(has(user_error_of([&] { load_colours(read.folder / "resources.psd"); }), "cut short"));
}

TEST_SUITE_END();
