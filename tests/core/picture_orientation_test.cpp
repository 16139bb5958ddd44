// Every way in which a format may hold a picture lying or mirrored, and every use that is made of it.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

constexpr std::array<glm::vec3, 4> seen{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1),
                                        glm::vec3(1)};

bool near_to(glm::vec3 a, glm::vec3 b) {
    return std::abs(a.x - b.x) < 0.06f && std::abs(a.y - b.y) < 0.06f && std::abs(a.z - b.z) < 0.06f;
}

// The colours in the middle of the four quarters, as one sees them.
template <class Pixels>
void check_quarters(const Pixels& pixels, int width, int height, int top = 0) {
    REQUIRE(pixels.size() >= static_cast<std::size_t>(width * height));
    for (int quarter = 0; quarter < 4; ++quarter) {
        CAPTURE(quarter);
        const int x = (quarter % 2 * 2 + 1) * width / 4, y = top + (quarter / 2 * 2 + 1) * height / 4;
        CHECK(near_to(glm::vec3(pixels[static_cast<std::size_t>(y * width + x)]),
                      seen[static_cast<std::size_t>(quarter)]));
    }
}

// As normals and heights, as an environment, as a stamp or a modulation.
void check_every_use(const fs::path& file) {
    CAPTURE(file.filename().string());
    const ColourPicture colours = load_colours(file);
    REQUIRE(colours.width == 64);
    REQUIRE(colours.height == 32);
    check_quarters(colours.colours, 64, 32);
    const LatLong light = load_lat_long(file);
    REQUIRE(light.width == 64);
    REQUIRE(light.height == 32);
    check_quarters(light.radiance, 64, 32);
    const Raster grey = load_picture(file, "test.nacre", "here", PictureShape::any);
    REQUIRE(grey.width == 64);
    const std::array<float, 4> luminances{0.2126f, 0.7152f, 0.0722f, 1.0f};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const int x = quarter % 2 * 32 + 16, y = 16 + quarter / 2 * 16 + 8;
        CHECK(grey.values[static_cast<std::size_t>(y * 64 + x)] ==
              doctest::Approx(luminances[static_cast<std::size_t>(quarter)]).epsilon(0.06));
    }
}

}  // namespace

TEST_SUITE_BEGIN("picture orientation");

TEST_CASE("picture orientation: EXIF's eight, in JPEG, TIFF and EXR") {
    const TemporaryFolder folder;
    for (const char* extension : {"jpg", "tif", "exr"})
        for (int orientation = 1; orientation <= 8; ++orientation) {
            const fs::path file = folder / ("lying-" + std::to_string(orientation) + "." + extension);
            write_picture(
                file, stored(quarters(), orientation),
                {.numbers = {{"Orientation", orientation}}, .texts = {{"CompressionQuality", "98"}}});
            check_every_use(file);
        }
}

TEST_CASE("picture orientation: EXIF's eight, in PNG and WebP") {
    const TemporaryFolder folder;
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const FloatImage image = stored(quarters(), orientation);
        const fs::path png = folder / ("lying-" + std::to_string(orientation) + ".png");
        write_picture(png, image);
        write_all(png, with_png_chunk(read_all(png), "eXIf", exif_block(orientation)));
        check_every_use(png);
        const fs::path webp = folder / ("lying-" + std::to_string(orientation) + ".webp");
        write_picture(webp, image, {.texts = {{"compression", "lossless"}}});
        write_all(webp, with_webp_exif(read_all(webp), image.size, orientation));
        check_every_use(webp);
    }
}

TEST_CASE("picture orientation: the eight orders of HDR's axes") {
    const TemporaryFolder folder;
    for (const char* y : {"+Y", "-Y"})
        for (const char* x : {"+X", "-X"}) {
            write_all(folder / "lines.hdr", hdr_file(quarters(), y, x));
            check_every_use(folder / "lines.hdr");
            write_all(folder / "columns.hdr", hdr_file(quarters(), x, y));
            check_every_use(folder / "columns.hdr");
        }
}

TEST_CASE("picture orientation: formats that store rows or columns the other way") {
    const TemporaryFolder folder;
    for (const char* order : {"increasingY", "decreasingY"}) {
        write_picture(folder / "order.exr", quarters(), {.texts = {{"openexr:lineOrder", order}}});
        check_every_use(folder / "order.exr");
    }
    for (const bool from_top : {false, true}) {
        write_all(folder / "order.bmp", bmp_file(quarters(), from_top));
        check_every_use(folder / "order.bmp");
        for (const bool from_right : {false, true})
            for (const bool run_lengths : {false, true}) {
                write_all(folder / "order.tga", targa_file(quarters(), from_right, from_top, run_lengths));
                check_every_use(folder / "order.tga");
            }
    }
    write_all(folder / "order.pfm", pfm_file(quarters()));
    check_every_use(folder / "order.pfm");
}

TEST_CASE("picture orientation: formats that know but one") {
    const TemporaryFolder folder;
    for (const char* name : {"plain.ppm", "plain.jp2", "plain.heic", "plain.webp", "plain.png"}) {
        write_picture(folder / name, quarters(), {.texts = {{"compression", "lossless"}}});
        check_every_use(folder / name);
    }
    write_all(folder / "plain.dds", dds_file(quarters()));
    check_every_use(folder / "plain.dds");
    write_all(folder / "plain.psd", psd_file(quarters()));
    check_every_use(folder / "plain.psd");
}

TEST_SUITE_END();
