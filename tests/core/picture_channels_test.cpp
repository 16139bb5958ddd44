// Which numbers of a file are the picture's, and what they mean.
#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <cmath>

#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace fs = std::filesystem;

namespace {

// Each channel holds its place in the list, from 1.
FloatImage counted(int channels) {
    FloatImage image{{2, 1}, channels, {}};
    for (int i = 0; i < 2 * channels; ++i) image.values.push_back(static_cast<float>(i % channels + 1));
    return image;
}

struct Named {
    const TemporaryFolder folder;
    fs::path file = folder / "named.exr";
    PictureNotes notes;

    glm::vec3 light(const std::vector<std::string>& channels) {
        write_picture(file, counted(static_cast<int>(channels.size())), {.channels = channels});
        notes.clear();
        return load_lat_long(file, &notes).radiance.at(0);
    }
    std::string refused(const std::vector<std::string>& channels) {
        return user_error_of([&] { light(channels); });
    }
};

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

// Parts of one EXR, each with three channels.
void write_parts(const fs::path& file, const std::vector<std::string>& first,
                 const std::vector<std::string>& second) {
    std::vector<OIIO::ImageSpec> specs;
    for (const auto& names : {first, second}) {
        specs.emplace_back(2, 1, 3, OIIO::TypeDesc::FLOAT);
        specs.back().channelnames = names;
        specs.back().attribute("oiio:subimagename", specs.size() == 1 ? "front" : "back");
    }
    const auto output = OIIO::ImageOutput::create("openexr");
    REQUIRE(output->open(file.string(), 2, specs.data()));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, counted(3).values.data()));
    REQUIRE(output->open(file.string(), specs[1], OIIO::ImageOutput::AppendSubimage));
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, counted(3).values.data()));
    REQUIRE(output->close());
}

}  // namespace

TEST_SUITE_BEGIN("picture channels");

TEST_CASE("picture channels: found by name, whatever their order") {
    Named named;
    CHECK(named.light({"R", "G", "B"}) == glm::vec3(1, 2, 3));
    CHECK(named.light({"B", "R", "G"}) == glm::vec3(2, 3, 1));
    CHECK(named.light({"red", "green", "blue"}) == glm::vec3(1, 2, 3));
    CHECK(named.light({"Y"}) == glm::vec3(1));
    CHECK(named.notes.empty());
    CHECK(named.light({"beauty.R", "beauty.G", "beauty.B"}) == glm::vec3(1, 2, 3));
    CHECK(named.light({"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B",
                       "ViewLayer.Depth.Z"}) == glm::vec3(1, 2, 3));
    // What else there is is said.
    CHECK(named.light({"R", "G", "B", "Z", "diffuse.R"}) == glm::vec3(1, 2, 3));
    REQUIRE(named.notes.size() == 1);
    CHECK(has(named.notes[0], "Z"));
    CHECK(has(named.notes[0], "diffuse.R"));
}

TEST_CASE("picture channels: what is not plainly a colour is refused by name") {
    Named named;
    CHECK(has(named.refused({"diffuse.R", "diffuse.G", "diffuse.B"}),
              "its channels are diffuse.R, diffuse.G, diffuse.B"));
    CHECK(has(named.refused({"N.X", "N.Y", "N.Z"}), "N.X, N.Y, N.Z"));
    CHECK(has(named.refused({"Z"}), "its channels are Z"));
    CHECK(has(named.refused({"A"}), "its channels are A"));
    CHECK(has(named.refused({"id", "velocity"}), "id, velocity"));
    CHECK(has(named.refused({"R", "G"}), "R, G"));
    CHECK(
        has(named.refused({"beauty.R", "beauty.G", "beauty.B", "image.R", "image.G", "image.B"}), "image.R"));
    std::vector<std::string> many;
    for (int i = 0; i < 40; ++i) many.push_back("layer" + std::to_string(i) + ".Z");
    CHECK(has(named.refused(many), "and 28 more"));
}

TEST_CASE("picture channels: two are data, not a look; a grey is repeated") {
    const TemporaryFolder folder;
    const auto colours = [&](const std::vector<std::string>& names) {
        write_picture(folder / "data.exr", counted(static_cast<int>(names.size())), {.channels = names});
        return load_colours(folder / "data.exr");
    };
    const ColourPicture two = colours({"R", "G"});
    CHECK(two.channels == 2);
    CHECK(two.colours[0] == glm::vec3(1, 2, 0));
    CHECK(!two.encoded);
    const ColourPicture grey = colours({"Y", "A"});
    CHECK(grey.channels == 1);
    CHECK(grey.colours[0] == glm::vec3(1));
}

TEST_CASE("picture channels: of an EXR in parts the first, where it is a colour") {
    const TemporaryFolder folder;
    const fs::path file = folder / "parts.exr";
    PictureNotes notes;
    write_parts(file, {"R", "G", "B"}, {"N.X", "N.Y", "N.Z"});
    CHECK(load_lat_long(file, &notes).radiance[0] == glm::vec3(1, 2, 3));
    REQUIRE(!notes.empty());
    CHECK(has(notes[0], "first of its 2 parts"));
    write_parts(file, {"N.X", "N.Y", "N.Z"}, {"R", "G", "B"});
    CHECK(has(user_error_of([&] { load_lat_long(file); }), "N.X"));
}

TEST_CASE("picture channels: an EXR's data is placed in its display window, for every use") {
    const TemporaryFolder folder;
    const fs::path file = folder / "window.exr";
    const FloatImage four{{4, 2}, 1, {1, 2, 3, 4, 5, 6, 7, 8}};
    // In the middle of what is shown: dark beside it.
    write_picture(file, four, {.window_at = {2, 1}, .display = {8, 4}});
    const LatLong inside = load_lat_long(file);
    REQUIRE(inside.width == 8);
    CHECK(inside.radiance[0].x == 0);
    CHECK(inside.radiance[8 + 2].x == 1);
    CHECK(inside.radiance[16 + 5].x == 8);
    CHECK(inside.radiance[31].x == 0);
    CHECK(load_colours(file).colours[8 + 3].x == 2);
    CHECK(load_picture(file, "", "", PictureShape::any).values[8 * 3 + 2] == 1);
    // Larger than what is shown: cut off.
    write_picture(file, four, {.window_at = {-1, -1}, .display = {2, 1}});
    const LatLong cropped = load_lat_long(file);
    REQUIRE(cropped.width == 2);
    CHECK(cropped.radiance[0].x == 6);
    CHECK(cropped.radiance[1].x == 7);
    // Tiled, and off the tiles' grid.
    write_picture(file, four, {.numbers = {}, .window_at = {-1, 0}, .display = {4, 2}});
    const ColourPicture shifted = load_colours(file);
    CHECK(shifted.colours[0].x == 2);
    CHECK(shifted.colours[3].x == 0);
    CHECK(shifted.colours[6].x == 8);
}

TEST_CASE("picture channels: other primaries become Rec. 709's, white stays") {
    const TemporaryFolder folder;
    const fs::path file = folder / "aces.exr";
    OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
    const float ap0[8] = {0.7347f, 0.2653f, 0, 1, 0.0001f, -0.077f, 0.32168f, 0.33767f};
    spec.attribute("chromaticities", OIIO::TypeDesc("float[8]"), ap0);
    const auto output = OIIO::ImageOutput::create("openexr");
    REQUIRE(output->open(file.string(), spec));
    const float pixels[6] = {0.5f, 0.5f, 0.5f, 0.4f, 0.5f, 0.3f};
    REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, pixels));
    REQUIRE(output->close());
    const LatLong light = load_lat_long(file);
    for (int c = 0; c < 3; ++c) CHECK(light.radiance[0][c] == doctest::Approx(0.5).epsilon(1e-4));
    // ACES2065-1 to linear Rec. 709 by its published matrix, which adapts white another way.
    CHECK(light.radiance[1].x == doctest::Approx(0.4 * 2.5217 - 0.5 * 1.1341 - 0.3 * 0.3876).epsilon(0.05));
    CHECK(light.radiance[1].y == doctest::Approx(-0.4 * 0.2765 + 0.5 * 1.3727 - 0.3 * 0.0963).epsilon(0.05));
    CHECK(light.radiance[1].z == doctest::Approx(-0.4 * 0.0154 - 0.5 * 0.1530 + 0.3 * 1.1684).epsilon(0.05));
    // Numbers are not colours.
    CHECK(load_colours(file).colours[1] == glm::vec3(0.4f, 0.5f, 0.3f));
}

TEST_CASE("picture channels: a PNG says how it is encoded") {
    const TemporaryFolder folder;
    const fs::path file = folder / "grey.png";
    write_picture(file, {{2, 1}, 1, {0.5f, 0.5f}});
    const std::string plain = read_all(file);
    const auto value = [&](const std::string& name, const std::string& data) {
        write_all(file, name.empty() ? plain : with_png_chunk(plain, name, data));
        return static_cast<double>(load_lat_long(file).radiance[0].x);
    };
    const double stored = 128 / 255.0, srgb = std::pow((stored + 0.055) / 1.055, 2.4);
    CHECK(value("", "") == doctest::Approx(srgb));
    CHECK(value("gAMA", std::string("\0\1\x86\xA0", 4)) == doctest::Approx(stored));           // 1
    CHECK(value("gAMA", std::string("\0\0\xB1\x8F", 4)) == doctest::Approx(srgb));             // 1/2.2
    CHECK(value("gAMA", std::string("\0\0\xC3\x50", 4)) == doctest::Approx(stored * stored));  // 1/2
    CHECK(value("sRGB", std::string(1, '\0')) == doctest::Approx(srgb));
}

TEST_CASE(
    "picture channels: alpha multiplies light once and leaves data alone, in every format that has it") {
    const TemporaryFolder folder;
    const float half = 128 / 255.f;
    for (const char* name : {"a.png", "a.exr", "a.tif", "a.tga"}) {
        CAPTURE(name);
        const bool is_float = std::string(name) == "a.exr";
        // White at half opacity: OpenImageIO takes it multiplied, and divides where the format wants that.
        FloatImage image{{2, 1}, 4, {half, half, half, half, 1, 1, 1, 1}};
        write_picture(folder / name, image, {.texts = {{"compression", is_float ? "zip" : "lossless"}}});
        const LatLong light = load_lat_long(folder / name);
        CHECK(light.radiance[0].x == doctest::Approx(half).epsilon(0.02));
        CHECK(light.radiance[1].x == doctest::Approx(1));
        const float data = load_colours(folder / name).colours[0].x;
        CHECK(data == doctest::Approx(std::string(name) == "a.exr" || std::string(name) == "a.tif" ? half : 1)
                          .epsilon(0.02));
    }
}

TEST_CASE("picture channels: WebP's colours come without alpha, exactly as they are stored") {
    const TemporaryFolder folder;
    const float half = 128 / 255.f;
    write_picture(folder / "a.webp", {{2, 1}, 4, {0.3f, 0.3f, 0.3f, half, 1, 1, 1, 1}},
                  {.texts = {{"compression", "lossless"}}});
    const double stored = static_cast<double>(load_colours(folder / "a.webp").colours[0].x);
    CHECK(stored > 0.3);
    CHECK(load_lat_long(folder / "a.webp").radiance[0].x ==
          doctest::Approx(std::pow((stored + 0.055) / 1.055, 2.4) * half).epsilon(1e-4));
}

TEST_SUITE_END();
