// Truevision TGA: what the header, the palette and the extension area say of the pixels.
#include <doctest/doctest.h>

#include <cmath>

#include "core/image/picture.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

std::string little(std::size_t value, int length) {
    std::string bytes;
    for (int i = 0; i < length; ++i) bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

// One pixel of a kind, with the footer of the second version and an extension area.
std::string targa(int kind, int depth, const std::string& pixel, const std::string& extension) {
    const std::string header = std::string(2, '\0') + static_cast<char>(kind) + std::string(9, '\0') +
                               little(1, 2) + little(1, 2) + static_cast<char>(depth) +
                               static_cast<char>(depth == 32 ? 8 : 0);
    return header + pixel + extension + little(header.size() + pixel.size(), 4) + little(0, 4) +
           "TRUEVISION-XFILE." + '\0';
}

// Texts that do not end, where `filling` is not 0.
std::string extension(char filling, unsigned gamma_over_10, char alpha_kind) {
    return little(495, 2) + std::string(476, filling) + little(gamma_over_10, 2) + little(10, 2) +
           std::string(12, '\0') + alpha_kind;
}

}  // namespace

TEST_SUITE_BEGIN("targa picture");

TEST_CASE("targa picture: a TGA's pixels name no colour that its palette does not have") {
    const TemporaryFolder folder;
    const std::string palette("\1\2\3\4\5\6", 6), footer = std::string(8, '\0') + "TRUEVISION-XFILE." + '\0';
    const auto refusal = [&](char first, char kind, const std::string& pixels) {
        const std::string header = std::string("\0\1", 2) + kind + first + std::string("\0\2\0\x18", 4) +
                                   std::string("\0\0\0\0\2\0\2\0\x08\0", 10);
        const std::filesystem::path file = folder / "a.tga";
        write_all(file, header + palette + pixels + footer);
        return user_error_of([&] { load_colours(file); });
    };
    constexpr char plain = 1, packed = 9;
    CHECK(refusal(0, plain, std::string("\0\1\1\0", 4)) == "");
    CHECK(refusal(0, packed, std::string("\x81\1\1\0\1", 5)) == "");
    CHECK(refusal(0, plain, std::string("\0\1\2\0", 4)).find("colour 2, its palette has 2") !=
          std::string::npos);
    CHECK(refusal(0, packed, std::string("\x83\xFF", 2)).find("colour 255") != std::string::npos);
    CHECK(refusal(0x3C, plain, std::string("\0\1\1\0", 4)).find("begins at colour 60") != std::string::npos);
}

TEST_CASE("targa picture: what the extension area says of gamma and alpha") {
    const TemporaryFolder folder;
    const auto value = [&](const std::string& bytes) {
        write_all(folder / "a.tga", bytes);
        return load_picture(folder / "a.tga", "test.nacre", "here", PictureShape::any).values[0];
    };
    const double half = 128 / 255.0;
    const auto srgb = [](double encoded) { return std::pow((encoded + 0.055) / 1.055, 2.4); };
    const std::string grey = "\x80", glass = "\x80\x80\x80\x80";
    constexpr char useful = 3, multiplied = 4;
    for (const char filling : {'\0', 'x'}) {
        CAPTURE(filling);
        CHECK(value(targa(3, 8, grey, extension(filling, 0, 0))) == doctest::Approx(srgb(half)));
        CHECK(value(targa(3, 8, grey, extension(filling, 22, 0))) == doctest::Approx(srgb(half)));
        CHECK(value(targa(3, 8, grey, extension(filling, 10, 0))) == doctest::Approx(half));
        CHECK(value(targa(3, 8, grey, extension(filling, 20, 0))) == doctest::Approx(half * half));
        CHECK(value(targa(2, 32, glass, extension(filling, 10, useful))) == doctest::Approx(half * half));
        CHECK(value(targa(2, 32, glass, extension(filling, 10, multiplied))) == doctest::Approx(half));
    }
}

TEST_CASE("targa picture: bits that its kind of pixels does not have are refused") {
    const TemporaryFolder folder;
    const auto refusal = [&](int kind, int depth) {
        write_all(folder / "a.tga", targa(kind, depth, "\1\2\3\4", extension(0, 0, 0)));
        return user_error_of([&] { load_colours(folder / "a.tga"); });
    };
    CHECK(has(refusal(2, 8), "8 bits a pixel with colours"));
    CHECK(has(refusal(3, 24), "24 bits a pixel with greys"));
    CHECK(has(refusal(1, 32), "32 bits a pixel with a palette"));
    CHECK(refusal(2, 24) == "");
    CHECK(refusal(3, 16) == "");
}

TEST_SUITE_END();
