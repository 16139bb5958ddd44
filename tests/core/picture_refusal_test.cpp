// Files that are no picture that a design can use: each error says which file, and why.
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>

#include "core/base/limits.h"
#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

Raster load(const fs::path& file) { return load_picture(file, "test.nacre", "here.image"); }

// The error of reading `file`, which must stand at the design and its place and name the picture.
std::string error_of(const fs::path& file) {
    const std::string line = user_error_of([&] { load(file); });
    if (!line.empty()) {
        const std::string start =
            "test.nacre: here.image: the picture " + file.string() + " cannot be used (";
        CHECK(line.starts_with(start));
        CHECK(line.size() > start.size() + 5);
    }
    return line;
}

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE_BEGIN("picture refusal");

TEST_CASE("picture refusal: a truncated one is an error wherever it is cut") {
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg", "a.hdr", "a.ppm"}) {
        write_picture(folder / name, noise({48, 48}));
        REQUIRE(load(folder / name).width == 48);
        const std::string whole = read_all(folder / name);
        for (const double part : {0.0, 0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 1.0}) {
            const auto length =
                std::min(static_cast<std::size_t>(part * double(whole.size())), whole.size() - 1);
            CAPTURE(name);
            CAPTURE(length);
            const fs::path cut = folder / (std::string("cut-") + name);
            write_all(cut, std::string_view(whole).substr(0, length));
            CHECK(has(error_of(cut), "cut-"));
        }
    }
}

TEST_CASE("picture refusal: a damaged PNG is an error") {
    const TemporaryFolder folder;
    write_picture(folder / "a.png", noise({32, 32}));
    std::string bytes = read_all(folder / "a.png");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_all(folder / "a.png", bytes);
    CHECK(has(error_of(folder / "a.png"), "damaged at byte"));
}

TEST_CASE("picture refusal: whatever is no picture is an error") {
    const TemporaryFolder folder;
    CHECK(has(error_of(folder / "missing.png"), "No such file or directory"));
    fs::create_directory(folder / "folder.png");
    CHECK(has(error_of(folder / "folder.png"), "a directory"));
    write_all(folder / "empty.png", "");
    CHECK(has(error_of(folder / "empty.png"), "no PNG"));
    write_all(folder / "text.exr", "I am not a picture,\nnot at all\n");
    CHECK(has(error_of(folder / "text.exr"), "no PNG"));
    write_all(folder / "a.null", "");
    CHECK(has(error_of(folder / "a.null"), "no PNG"));
}

TEST_CASE("picture refusal: devices, pipes and huge files are refused before they are read") {
    const TemporaryFolder folder;
    CHECK(has(error_of("/dev/zero"), "not a regular file"));
    fs::create_symlink("/dev/zero", folder / "endless.png");
    CHECK(has(error_of(folder / "endless.png"), "not a regular file"));
    REQUIRE(mkfifo((folder / "pipe.png").c_str(), 0600) == 0);
    CHECK(has(error_of(folder / "pipe.png"), "not a regular file"));
    write_all(folder / "big.png", "x");
    fs::resize_file(folder / "big.png", limits::file_bytes_max + 1);
    CHECK(has(error_of(folder / "big.png"), "268435457 bytes"));
}

TEST_CASE("picture refusal: a huge declared size is refused from the header") {
    const TemporaryFolder folder;
    write_all(folder / "a.ppm", "P6\n60000 60000\n255\nabc");
    CHECK(has(error_of(folder / "a.ppm"), "60000 x 60000 pixels, more than 4096 a side"));
    // A PNG that declares 2147483647 pixels a side, checksums intact.
    constexpr unsigned char png[] = {
        0x89, 'P',  'N',  'G',  13,   10,   26,   10,   0,    0,    0,    13,   'I',  'H',  'D',  'R',  0x7f,
        0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff, 8,    0,    0,    0,    0,    0x31, 0xa2, 0x54, 0xba, 0,
        0,    0,    11,   'I',  'D',  'A',  'T',  0x78, 0x9c, 0x63, 0x60, 0x80, 1,    0,    0,    0x0a, 0,
        1,    0x7f, 0x80, 0x74, 0x5e, 0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xae, 0x42, 0x60, 0x82};
    write_all(folder / "a.png", {reinterpret_cast<const char*>(png), sizeof(png)});
    CHECK(has(error_of(folder / "a.png"), "2147483647 x 2147483647 pixels, more than 4096 a side"));
}

TEST_CASE("picture refusal: the shape must fit") {
    const TemporaryFolder folder;
    write_picture(folder / "wide.png", {{3, 2}, 1, std::vector<float>(6, 1.f)});
    CHECK(has(error_of(folder / "wide.png"), "3 x 2 pixels, a picture must be square"));
    write_picture(folder / "large.tif", {{4097, 4097}, 1, std::vector<float>(4097u * 4097u, 1.f)});
    CHECK(has(error_of(folder / "large.tif"), "4097 x 4097 pixels, more than 4096 a side"));
}

TEST_CASE("picture refusal: a pixel that is no amount of facets is named") {
    const TemporaryFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity, -0.5f}) {
        std::vector<float> pixels(27, 0.5f);
        pixels[3 * 5 + 1] = bad;
        write_picture(folder / "a.exr", {{3, 3}, 3, pixels});
        CHECK(has(error_of(folder / "a.exr"), "pixel (2, 1) from the top left"));
    }
}

TEST_SUITE_END();
