// Rasters made of pictures, with their settings.
#include "core/paint/source_raster.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "core/image/image_file.h"
#include "core/model/facet_distribution.h"
#include "core/paint/raster_texels.h"
#include "tests/core/designs.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

// White in the right half alone, twice as high at its top.
void write_half(const fs::path& file) {
    std::vector<float> rgb;
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column)
            rgb.insert(rgb.end(), 3, column < 16 ? 0.0f : row < 16 ? 1.0f : 0.5f);
    write_image(file, {32, 32}, rgb);
}

void write_leaning(const fs::path& file, dvec3 n) {
    std::vector<float> rgb;
    for (int i = 0; i < 64; ++i)
        for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<float>(n[c]));
    write_image(file, {8, 8}, rgb);
}

dvec3 mean_of(const std::shared_ptr<const Raster>& raster) {
    return FacetDistribution(test::design_of(PaintedLobe{{{}, raster}}).distribution).mean();
}

PictureSource source_of(const fs::path& image, SourceUse as) {
    PictureSource source;
    source.image = image;
    source.as = as;
    return source;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

TEST_CASE(
    "source raster: a stamp stands upright where it shines, as large, turned and mirrored as it is set") {
    const test::TemporaryFolder folder;
    write_half(folder / "half.exr");
    ImportedPicture picture(folder / "half.exr");
    PictureSource source = source_of(picture.file(), SourceUse::stamp);
    source.size = 20;
    const auto value = [&](double x, double y) {
        const auto raster = made_raster(picture, source).raster;
        const double theta = std::hypot(x, y) * std::numbers::pi / 180, phi = std::atan2(-y, -x);
        const dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        return raster_value(raster->values, raster->width, disk_point(h));
    };
    // Degrees to the right and up, as it shines.
    CHECK(value(10, 10) == doctest::Approx(1).epsilon(0.01));
    CHECK(value(10, -10) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(value(-10, 10) == 0);
    CHECK(value(19, 10) > 0.9);
    CHECK(value(22, 10) == 0);
    source.size = 40;
    CHECK(value(35, 10) > 0.9);
    source.flip = true;
    CHECK(value(-10, 10) == doctest::Approx(1).epsilon(0.01));
    CHECK(value(10, 10) == 0);
    source.flip = false;
    source.rotation = 90;  // the right half comes to the top
    CHECK(value(-10, 10) == doctest::Approx(1).epsilon(0.01));
    CHECK(value(10, 10) == doctest::Approx(0.5).epsilon(0.01));
    CHECK(value(10, -10) == 0);
}

TEST_CASE("source raster: normals are mirrored, then turned") {
    const test::TemporaryFolder folder;
    const double lean = std::numbers::pi / 6;
    write_leaning(folder / "right.exr", {std::sin(lean), 0, std::cos(lean)});
    ImportedPicture picture(folder / "right.exr");
    struct {
        double rotation;
        bool flip;
        glm::dvec2 toward;
    } const cases[] = {{0, false, {1, 0}},
                       {90, false, {0, 1}},
                       {0, true, {-1, 0}},
                       {90, true, {0, -1}},
                       {-90, false, {0, -1}}};
    for (const auto& c : cases) {
        CAPTURE(c.rotation);
        CAPTURE(c.flip);
        PictureSource source = source_of(picture.file(), SourceUse::normals);
        source.reading = picture.look().reading;
        source.rotation = c.rotation;
        source.flip = c.flip;
        const dvec3 mean = mean_of(made_raster(picture, source).raster);
        CHECK(degrees(std::asin(mean.x)) == doctest::Approx(30 * c.toward.x).epsilon(0.02).scale(30));
        CHECK(degrees(std::asin(mean.y)) == doctest::Approx(30 * c.toward.y).epsilon(0.02).scale(30));
    }
}

TEST_CASE("source raster: a draft is near to what all pixels give, of normals and of heights") {
    const test::TemporaryFolder folder;
    constexpr int side = 600;
    std::vector<float> rgb;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            rgb.insert(rgb.end(), 3,
                       static_cast<float>(0.5 + 0.5 * std::sin(column * 0.11) * std::cos(row * 0.05)));
    write_image(folder / "hills.exr", {side, side}, rgb);
    ImportedPicture picture(folder / "hills.exr");
    CHECK(draft_step(picture.colours()) == 3);
    PictureSource source = source_of(picture.file(), SourceUse::heights);
    source.height = 3;
    const auto whole = made_raster(picture, source).raster, draft = made_raster(picture, source, 3).raster;
    double off = 0, sum = 0;
    for (std::size_t i = 0; i < whole->values.size(); ++i) {
        off += std::abs(static_cast<double>(whole->values[i] - draft->values[i]));
        sum += static_cast<double>(whole->values[i]);
    }
    CHECK(sum > 0);
    CHECK(off < 0.05 * sum);
}

TEST_CASE(
    "source raster: a modulation stands upright where it shines, whatever the layer's rotation and tilt "
    "are") {
    const test::TemporaryFolder folder;
    write_half(folder / "half.exr");
    ImportedPicture picture(folder / "half.exr");
    struct {
        double rotation, tilt, azimuth;
    } const layers[] = {{0, 0, 0}, {90, 0, 0}, {-130, 0, 0}, {0, 30, 0}, {40, 30, 110}};
    for (const auto& c : layers) {
        CAPTURE(c.rotation);
        CAPTURE(c.tilt);
        Layer layer;
        layer.rotation = c.rotation;
        layer.tilt = c.tilt;
        layer.azimuth = c.azimuth;
        const auto raster = made_modulation(picture, layer, {}).raster;
        const glm::dmat3 frame = layer_frame(layer);
        // Small steps on the surface from the lobe's axis: right and up as it shines is left and down in h.
        const auto value = [&](double x, double y) {
            const dvec3 axis = frame[2], step(-x, -y, 0);
            const dvec3 h =
                glm::transpose(frame) * glm::normalize(axis + (step - glm::dot(step, axis) * axis));
            return raster_value(raster->values, raster->width, disk_point(h));
        };
        CHECK(value(0.3, 0.3) == doctest::Approx(1).epsilon(0.02));
        CHECK(value(0.3, -0.3) == doctest::Approx(0.5).epsilon(0.02));
        CHECK(value(-0.3, 0.3) == doctest::Approx(0).scale(1).epsilon(0.01));
    }
    // Turned by half a circle no value changes.
    const auto plain = made_modulation(picture, Layer{}, {}).raster;
    const std::vector<float>& given = picture.modulation().raster->values;
    CHECK(std::vector<float>(plain->values.rbegin(), plain->values.rend()) == given);
    PictureSource flipped;
    flipped.flip = true;
    const auto mirrored = made_modulation(picture, Layer{}, flipped).raster;
    CHECK(mirrored->values.front() == given[32 * 31]);
}

TEST_CASE("source raster: what holds no facets is refused") {
    const test::TemporaryFolder folder;
    write_image(folder / "black.exr", {4, 4}, std::vector<float>(48, 0));
    ImportedPicture picture(folder / "black.exr");
    for (const SourceUse as : {SourceUse::stamp, SourceUse::normals})
        CHECK_THROWS_AS(made_raster(picture, source_of(picture.file(), as)), UserError);
}

TEST_CASE("source raster: a file that has changed is not current") {
    const test::TemporaryFolder folder;
    write_half(folder / "half.exr");
    ImportedPicture picture(folder / "half.exr");
    CHECK(picture.is_current());
    write_image(folder / "half.exr", {4, 4}, std::vector<float>(48, 1));
    CHECK(!picture.is_current());
}
