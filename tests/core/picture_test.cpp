#include "core/exchange/picture.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/exchange/area_average.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

struct Image {
    int width;
    int height;
    int channels;
    std::vector<float> pixels;
    OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
    std::pair<const char*, int> attribute = {"", 0};
};

void write_image(const fs::path& file, const Image& image) {
    const auto output = OIIO::ImageOutput::create(file.string());
    REQUIRE(output);
    OIIO::ImageSpec spec(image.width, image.height, image.channels, image.type);
    if (*image.attribute.first) spec.attribute(image.attribute.first, image.attribute.second);
    REQUIRE(output->open(file.string(), spec));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data()));
    REQUIRE(output->close());
}

Image noise(int side, int channels, OIIO::TypeDesc type) {
    Image image{side, side, channels, {}, type};
    std::uint32_t state = 1;
    for (int i = 0; i < side * side * channels; ++i) {
        state = state * 1664525u + 1013904223u;
        image.pixels.push_back(static_cast<float>(state >> 8) / float(1 << 24));
    }
    return image;
}

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

float srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

TEST_SUITE("picture") {
    TEST_CASE("picture: float pictures are linear, top row first") {
        const TemporaryFolder folder;
        const std::vector<float> pixels = {0, 0.25f, 3.5f, 1e-3f};
        for (const char* name : {"a.exr", "a.tif", "a.hdr"}) {
            const int channels = fs::path(name).extension() == ".hdr" ? 3 : 1;
            Image image{2, 2, channels, {}, OIIO::TypeDesc::FLOAT};
            for (const float value : pixels)
                for (int c = 0; c < channels; ++c) image.pixels.push_back(value);
            write_image(folder / name, image);
            const Raster raster = load(folder / name);
            CHECK(raster.width == 2);
            CHECK(raster.height == 2);
            for (std::size_t i = 0; i < 4; ++i)
                CHECK(raster.values[i] == doctest::Approx(pixels[i]).epsilon(channels == 1 ? 1e-7 : 0.01));
        }
    }

    TEST_CASE("picture: 8 and 16 bit pictures are decoded from sRGB") {
        const TemporaryFolder folder;
        const std::vector<float> grey = {0, 51 / 255.f, 128 / 255.f, 1};
        for (const char* name : {"a.png", "a.tif", "a.pgm"})
            for (const OIIO::TypeDesc type : {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16}) {
                CAPTURE(name);
                write_image(folder / name, {2, 2, 1, grey, type});
                const Raster raster = load(folder / name);
                for (std::size_t i = 0; i < 4; ++i)
                    CHECK(raster.values[i] == doctest::Approx(srgb(grey[i])).epsilon(1e-4));
            }
    }

    TEST_CASE("picture: colours become Rec. 709 luminance") {
        const TemporaryFolder folder;
        const std::vector<float> primaries = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
        for (const char* name : {"a.png", "a.exr"}) {
            const bool is_float = fs::path(name).extension() == ".exr";
            write_image(folder / name,
                        {2, 2, 3, primaries, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8});
            const Raster raster = load(folder / name);
            CHECK(raster.values[0] == doctest::Approx(0.2126));
            CHECK(raster.values[1] == doctest::Approx(0.7152));
            CHECK(raster.values[2] == doctest::Approx(0.0722));
            CHECK(raster.values[3] == doctest::Approx(1));
        }
    }

    TEST_CASE("picture: alpha multiplies once, whether or not the file has multiplied it in") {
        const TemporaryFolder folder;
        // A white pixel at three opacities, and a black one; OpenImageIO writes PNG as unassociated.
        const std::vector<float> opacities = {0, 128 / 255.f, 1, 1};
        for (const char* name : {"a.png", "a.exr", "a.tif"})
            for (const int channels : {2, 4}) {
                CAPTURE(name);
                CAPTURE(channels);
                Image image{2, 2, channels, {}, OIIO::TypeDesc::UINT8};
                if (fs::path(name).extension() == ".exr") image.type = OIIO::TypeDesc::FLOAT;
                for (std::size_t i = 0; i < 4; ++i) {
                    for (int c = 1; c < channels; ++c) image.pixels.push_back(i < 3 ? opacities[i] : 0);
                    image.pixels.push_back(opacities[i]);
                }
                const auto output = OIIO::ImageOutput::create((folder / name).string());
                OIIO::ImageSpec spec(2, 2, channels, image.type);
                spec.channelnames = channels == 2 ? std::vector<std::string>{"Y", "A"}
                                                  : std::vector<std::string>{"R", "G", "B", "A"};
                spec.alpha_channel = channels - 1;
                REQUIRE(output->open((folder / name).string(), spec));
                REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data()));
                REQUIRE(output->close());
                const Raster raster = load(folder / name);
                CHECK(raster.values[0] == 0);
                CHECK(raster.values[1] == doctest::Approx(128 / 255.).epsilon(0.01));
                CHECK(raster.values[2] == doctest::Approx(1));
                CHECK(raster.values[3] == 0);
            }
    }

    TEST_CASE("picture: a picture taken lying is turned upright") {
        const TemporaryFolder folder;
        const fs::path file = folder / "a.tif";
        // Rows that the file holds, and what orientation 6 (turn clockwise) and 3 (upside down) show.
        const std::vector<float> stored = {1, 2, 3, 4};
        write_image(file, {2, 2, 1, stored, OIIO::TypeDesc::FLOAT, {"Orientation", 6}});
        CHECK(load(file).values == std::vector<float>{3, 1, 4, 2});
        write_image(file, {2, 2, 1, stored, OIIO::TypeDesc::FLOAT, {"Orientation", 3}});
        CHECK(load(file).values == std::vector<float>{4, 3, 2, 1});
    }

    TEST_CASE("picture: a large one is averaged down by area") {
        const TemporaryFolder folder;
        const int side = 1500;
        const Image image = noise(side, 1, OIIO::TypeDesc::FLOAT);
        write_image(folder / "a.exr", image);
        const Raster raster = load(folder / "a.exr");
        REQUIRE(raster.width == limits::raster_max);
        REQUIRE(raster.values.size() == std::size_t(limits::raster_max) * limits::raster_max);
        const auto mean = [](const std::vector<float>& values) {
            return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
        };
        CHECK(mean(raster.values) == doctest::Approx(mean(image.pixels)).epsilon(1e-6));
        // The first pixel covers 1500/1024 = 1.4648 pixels a side.
        const double part = side / 1024.0 - 1;
        const std::vector<float>& p = image.pixels;
        const double first =
            (p[0] + part * (p[1] + p[side]) + part * part * p[side + 1]) / ((1 + part) * (1 + part));
        CHECK(raster.values[0] == doctest::Approx(first).epsilon(1e-6));
    }

    TEST_CASE("picture: area averages keep rows and columns apart") {
        const Raster raster{4, 4, {1, 1, 2, 2, 1, 1, 2, 2, 3, 3, 4, 4, 3, 3, 4, 8}};
        CHECK(area_average(raster, 2) == Raster{2, 2, {1, 2, 3, 5}});
        CHECK(area_average(raster, 4) == raster);
    }

    TEST_CASE("picture: a truncated one is an error wherever it is cut") {
        const TemporaryFolder folder;
        for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg", "a.hdr", "a.ppm"}) {
            const std::string extension = fs::path(name).extension();
            const bool is_float = extension == ".exr" || extension == ".hdr";
            write_image(folder / name,
                        noise(48, 3, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8));
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

    TEST_CASE("picture: a damaged PNG is an error") {
        const TemporaryFolder folder;
        write_image(folder / "a.png", noise(32, 3, OIIO::TypeDesc::UINT8));
        std::string bytes = read_all(folder / "a.png");
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
        write_all(folder / "a.png", bytes);
        CHECK(has(error_of(folder / "a.png"), "damaged at byte"));
    }

    TEST_CASE("picture: whatever is no picture is an error") {
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

    TEST_CASE("picture: devices, pipes and huge files are refused before they are read") {
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

    TEST_CASE("picture: a huge declared size is refused from the header") {
        const TemporaryFolder folder;
        write_all(folder / "a.ppm", "P6\n60000 60000\n255\nabc");
        CHECK(has(error_of(folder / "a.ppm"), "60000 x 60000 pixels, more than 4096 a side"));
        // A PNG that declares 2147483647 pixels a side, checksums intact.
        constexpr unsigned char png[] = {0x89, 'P',  'N', 'G', 13,   10,   26,   10,   0,    0,    0,    13,
                                         'I',  'H',  'D', 'R', 0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff,
                                         8,    0,    0,   0,   0,    0x31, 0xa2, 0x54, 0xba, 0,    0,    0,
                                         11,   'I',  'D', 'A', 'T',  0x78, 0x9c, 0x63, 0x60, 0x80, 1,    0,
                                         0,    0x0a, 0,   1,   0x7f, 0x80, 0x74, 0x5e, 0,    0,    0,    0,
                                         'I',  'E',  'N', 'D', 0xae, 0x42, 0x60, 0x82};
        write_all(folder / "a.png", {reinterpret_cast<const char*>(png), sizeof(png)});
        CHECK(has(error_of(folder / "a.png"), "2147483647 x 2147483647 pixels, more than 4096 a side"));
    }

    TEST_CASE("picture: the shape must fit") {
        const TemporaryFolder folder;
        write_image(folder / "wide.png", {3, 2, 1, std::vector<float>(6, 1.f)});
        CHECK(has(error_of(folder / "wide.png"), "3 x 2 pixels, a picture must be square"));
        write_image(folder / "large.tif", {4097, 4097, 1, std::vector<float>(4097u * 4097u, 1.f)});
        CHECK(has(error_of(folder / "large.tif"), "4097 x 4097 pixels, more than 4096 a side"));
    }

    TEST_CASE("picture: one that may have any shape keeps it, with nothing beside it") {
        const TemporaryFolder folder;
        const auto letterbox = [&](const char* name) {
            return load_picture(folder / name, "test.nacre", "here.image", PictureShape::any);
        };
        write_image(folder / "wide.exr", {4, 2, 1, {1, 2, 3, 4, 5, 6, 7, 8}, OIIO::TypeDesc::FLOAT});
        const Raster wide = letterbox("wide.exr");
        CHECK(wide == Raster{4, 4, {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 0, 0}});
        // Lying as it was taken, a column of four when upright.
        write_image(folder / "tall.exr", {4, 1, 1, {1, 2, 3, 4}, OIIO::TypeDesc::FLOAT, {"Orientation", 6}});
        const Raster tall = letterbox("tall.exr");
        CHECK(tall == Raster{4, 4, {0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0}});
        // Averaged down afterwards, so that pixels stay square and the sum per area stays.
        const int side = limits::raster_max * 2;
        write_image(folder / "strip.tif", {side, 64, 1, std::vector<float>(std::size_t(side) * 64, 1.f)});
        const Raster strip = letterbox("strip.tif");
        CHECK(strip.width == limits::raster_max);
        const double sum = std::accumulate(strip.values.begin(), strip.values.end(), 0.0);
        CHECK(sum == doctest::Approx(32.0 * limits::raster_max));
        write_image(folder / "square.exr", noise(5, 1, OIIO::TypeDesc::FLOAT));
        CHECK(letterbox("square.exr") == load(folder / "square.exr"));
    }

    TEST_CASE("picture: a pixel that is no amount of facets is named") {
        const TemporaryFolder folder;
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const float infinity = std::numeric_limits<float>::infinity();
        for (const float bad : {nan, infinity, -infinity, -0.5f}) {
            std::vector<float> pixels(27, 0.5f);
            pixels[3 * 5 + 1] = bad;
            write_image(folder / "a.exr", {3, 3, 3, pixels, OIIO::TypeDesc::FLOAT});
            CHECK(has(error_of(folder / "a.exr"), "pixel (2, 1) from the top left"));
        }
    }
}
