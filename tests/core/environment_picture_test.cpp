// Environment maps as they are found: with light below 0, of odd shapes, too bright, too large.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/formats/environment_file.h"
#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

FloatImage even(glm::ivec2 size, int channels, float value) {
    return {size, channels,
            std::vector<float>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                                   static_cast<std::size_t>(channels),
                               value)};
}

double mean(const LatLong& light) {
    double sum = 0;
    for (const glm::vec3 c : light.radiance) sum += static_cast<double>(c.x + c.y + c.z) / 3;
    return sum / static_cast<double>(light.radiance.size());
}

}  // namespace

TEST_SUITE_BEGIN("environment picture");

TEST_CASE("environment picture: light below 0 counts as 0, and is counted") {
    const TemporaryFolder folder;
    const fs::path file = folder / "ringing.exr";
    FloatImage image = even({8, 4}, 3, 1);
    image.values[0] = -1e-3f;
    image.values[5] = -3894;
    image.values[30] = -2;
    image.values[31] = -2;
    write_picture(file, image);
    PictureNotes notes;
    const LatLong light = load_lat_long(file, &notes);
    CHECK(light.radiance[0] == glm::vec3(0, 1, 1));
    CHECK(light.radiance[1] == glm::vec3(1, 1, 0));
    CHECK(light.radiance[10] == glm::vec3(0, 0, 1));
    REQUIRE(notes.size() == 1);
    CHECK(notes[0] == "3 of 32 pixels are below 0, down to -3894, and count as 0");
    CHECK(load_environment(file.string())->notes == notes);
}

TEST_CASE("environment picture: NaN and infinity are refused with their place") {
    const TemporaryFolder folder;
    const fs::path file = folder / "broken.exr";
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        FloatImage image = even({8, 4}, 3, 1);
        image.values[30] = bad;
        write_picture(file, image);
        CHECK(user_error_of([&] { load_lat_long(file); }).find("pixel (2, 1) from the top left") !=
              std::string::npos);
    }
}

TEST_CASE("environment picture: light past all measure is bounded, counted, and leaves no infinity") {
    const TemporaryFolder folder;
    constexpr double bound = 1e15, sphere = 4 * 3.14159265358979;
    for (const int width : {64, 4096}) {
        const fs::path file = folder / ("sun-" + std::to_string(width) + ".exr");
        write_picture(file, even({width, width / 2}, 1, std::numeric_limits<float>::max()));
        const auto environment = load_environment(file.string());
        CHECK(environment->brightness == doctest::Approx(sphere * bound));
        for (const glm::vec3 c : environment->picture.radiance)
            if (c != glm::vec3(static_cast<float>(bound))) FAIL("not the bound");
        CHECK(environment->light_density(glm::dvec3(bound)) == doctest::Approx(1 / sphere));
        REQUIRE(!environment->notes.empty());
        CHECK(environment->notes[0].find("above 1e+15, up to 3.403e+38") != std::string::npos);
    }
}

TEST_CASE("environment picture: what is not quite twice as wide as high is fitted, with a word") {
    const TemporaryFolder folder;
    const fs::path file = folder / "odd.exr";
    struct Case {
        glm::ivec2 from, to;
    };
    for (const auto& [from, to] :
         {Case{{128, 42}, {128, 64}}, Case{{127, 64}, {128, 64}}, Case{{129, 64}, {130, 65}},
          Case{{100, 64}, {128, 64}}, Case{{2049, 1024}, {2048, 1024}}}) {
        // Brighter from the left to the right and from the top down.
        FloatImage image = even(from, 3, 0);
        for (int y = 0; y < from.y; ++y)
            for (int x = 0; x < from.x; ++x)
                for (int c = 0; c < 3; ++c)
                    image.values[static_cast<std::size_t>((y * from.x + x) * 3 + c)] =
                        (static_cast<float>(x) + 0.5f) / static_cast<float>(from.x) +
                        (static_cast<float>(y) + 0.5f) / static_cast<float>(from.y);
        write_picture(file, image);
        PictureNotes notes;
        const LatLong light = load_lat_long(file, &notes);
        CHECK(glm::ivec2(light.width, light.height) == to);
        CHECK(mean(light) == doctest::Approx(1).epsilon(1e-5));
        CHECK(light.radiance.front().x < light.radiance.back().x);
        CHECK(light.radiance[static_cast<std::size_t>(to.y / 2 * to.x + to.x / 2)].x ==
              doctest::Approx(1).epsilon(0.03));
        REQUIRE(notes.size() == 1);
        CHECK(notes[0].find("fitted to") != std::string::npos);
    }
    for (const glm::ivec2 size : {glm::ivec2(5, 5), glm::ivec2(64, 48), glm::ivec2(60, 10)}) {
        write_picture(file, even(size, 3, 1));
        CHECK(user_error_of([&] { load_lat_long(file); }).find("must be twice as wide as high") !=
              std::string::npos);
    }
}

TEST_CASE("environment picture: a large one is averaged down, in every kind of file, and says so") {
    const TemporaryFolder folder;
#ifdef NACRE_SANITIZED  // ten times as slow
    const glm::ivec2 size(2200, 1100);
#else
    const glm::ivec2 size(4400, 2200);
#endif
    for (const char* name : {"large.png", "large.jpg", "large.webp", "large.tga"}) {
        CAPTURE(name);
        const int channels = std::string(name) == "large.webp" ? 3 : 1;
        write_picture(folder / name, even(size, channels, 1), {.texts = {{"compression", "lossless"}}});
        PictureNotes notes;
        const LatLong light = load_lat_long(folder / name, &notes);
        CHECK(light.width == 2048);
        CHECK(light.radiance.size() == 2048 * 1024);
        CHECK(light.radiance[777].y == doctest::Approx(1).epsilon(1e-6));
        CHECK(light.radiance.back().z == doctest::Approx(1).epsilon(1e-6));
        REQUIRE(notes.size() == 1);
        CHECK(notes[0] == fmt::format("{} x {} pixels, averaged down to 2048 x 1024", size.x, size.y));
    }
}

TEST_CASE("environment picture: past 16384 x 8192 is refused from the header") {
    const TemporaryFolder folder;
    for (const char* header : {"P6\n16386 8193\n255\n", "P6\n8192 16384\n255\n"}) {
        write_all(folder / "huge.ppm", header);
        CHECK(user_error_of([&] { load_lat_long(folder / "huge.ppm"); }).find("more than 16384 x 8192") !=
              std::string::npos);
    }
}

TEST_SUITE_END();
