// What a picture's numbers mean once it is read.
#include "core/image/picture.h"
#include "core/base/limits.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "core/image/area_average.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using nacre::test::noise;
using nacre::test::read_all;
using nacre::test::TemporaryFolder;
using nacre::test::write_all;

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

Raster load(const fs::path& file) { return load_picture(file, "test.nacre", "here.image"); }

float srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

TEST_SUITE_BEGIN("picture");

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
    const Image image{side, side, 1, noise({side, side}, 1).values, OIIO::TypeDesc::FLOAT};
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
    write_image(folder / "square.exr", {5, 5, 1, noise({5, 5}, 1).values, OIIO::TypeDesc::FLOAT});
    CHECK(letterbox("square.exr") == load(folder / "square.exr"));
}

TEST_SUITE_END();
