// Pictures dropped on the window.
#include "app/designer/image_import.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "core/image/image_file.h"
#include "core/model/facet_distribution.h"
#include "core/paint/painted_layer.h"
#include "tests/designer/folder_rig.h"

using namespace nacre;
using test::FolderRig;
namespace fs = std::filesystem;

namespace {

// Steel brushed along y: grooves whose sides lean along x, a little noise along y.
void write_brushed_steel(const fs::path& file) {
    constexpr int side = 64;
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    std::vector<float> rgb;
    std::vector<double> groove(side);
    for (double& slope : groove) slope = 0.3 * normal(random);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const glm::dvec3 n = glm::normalize(
                glm::dvec3(groove[static_cast<std::size_t>(column)], 0.02 * normal(random), 1));
            for (int i = 0; i < 3; ++i) rgb.push_back(static_cast<float>(0.5 + 0.5 * n[i]));
        }
    write_image(file, {side, side}, rgb);
}

// Grooves along y, all of one slope: the height goes up and down 8 times over the width.
void write_grooves(const fs::path& file) {
    constexpr int side = 128, period = 16;
    std::vector<float> rgb;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const int at = column % period;
            const float height = static_cast<float>(std::min(at, period - at)) / (period / 2);
            rgb.insert(rgb.end(), 3, height);
        }
    write_image(file, {side, side}, rgb);
}

// Root mean squares of x and y over a layer's facets.
glm::dvec2 spread(const Layer& layer) {
    Distribution alone;
    alone.layers = {layer};
    const FacetDistribution p(alone);
    glm::dvec2 squares(0);
    double mass = 0;
    const auto facets = p.facets(0);
    for (const Facet& facet : facets.front()) {
        squares += facet.mass * glm::dvec2(facet.h.x * facet.h.x, facet.h.y * facet.h.y);
        mass += facet.mass;
    }
    return glm::sqrt(squares / mass);
}

}  // namespace

TEST_CASE("picture: a brushed-steel normal map gives a streak across the brushing") {
    FolderRig r;
    write_brushed_steel(r.folder / "steel.exr");
    const Design before = r.stage.designer().document.design;
    r.play(r.drop("steel.exr") + r.import("Normals"));
    REQUIRE(r.layers().size() == 2);
    CHECK(r.layers()[1].name == "steel");
    CHECK(r.layers()[1].enabled);
    CHECK(r.stage.designer().baker.problem().empty());
    const glm::dvec2 across = spread(r.layers()[1]);
    CHECK(across.x > 0.2);
    CHECK(across.x / across.y > 5);
    r.play("key Ctrl+Z");
    CHECK(r.stage.designer().document.design == before);
}

TEST_CASE("picture: how a map of normals is read is shown, and can be chosen for it") {
    FolderRig r;
    // All lean up by 30 degrees, in signed numbers.
    std::vector<float> rgb;
    for (int i = 0; i < 64; ++i) rgb.insert(rgb.end(), {0.0f, 0.5f, 0.8660254f});
    rgb[5] = 1.2f;
    write_image(r.folder / "leaning.exr", {8, 8}, rgb);
    const std::string drop = r.drop("leaning.exr");
    const auto mean = [&](const std::string& choices) {
        r.play(drop + r.card("Normals") + choices + r.accept());
        Distribution alone;
        alone.layers = {r.layers().back()};
        return FacetDistribution(alone).mean();
    };
    const auto leans = [](const dvec3& n) { return std::asin(n.y) * 180 / 3.14159265358979; };
    CHECK(leans(mean("")) == doctest::Approx(30).epsilon(0.02));
    CHECK(r.designer().files.message() == "leaning.exr: of 64 pixels 1 brought to length 1");
    CHECK(leans(mean("click \"Down (DirectX)\"\nframes 2\n")) == doctest::Approx(-30).epsilon(0.02));
    CHECK(leans(mean("")) == doctest::Approx(-30).epsilon(0.02));  // for this session
    // 2 c - 1 of them: x is -1, y is 0.
    const dvec3 encoded = mean("click \"0.5 is zero\"\nframes 2\n");
    CHECK(encoded.x < -0.7);
    CHECK(std::abs(encoded.y) < 0.02);
    CHECK(leans(mean("click \"Signed\"\nclick \"x and y\"\nclick \"Up (OpenGL)\"\nframes 2\n")) ==
          doctest::Approx(30).epsilon(0.02));
    // Another map is read by its own numbers.
    write_brushed_steel(r.folder / "steel.exr");
    r.play(r.drop("steel.exr") + r.import("Normals"));
    CHECK(spread(r.layers().back()).x > 0.2);
}

TEST_CASE("picture: a grey one holds no normals, and says so") {
    FolderRig r;
    std::ofstream(r.folder / "grey.pgm") << "P2 2 2 255\n0 100 200 255\n";
    const Design before = r.designer().document.design;
    r.play(r.drop("grey.pgm") + r.import("Normals"));
    CHECK(r.designer().pictures.talking());
    r.play("move \"As Normals\"\nframes 60");
    CHECK(r.stage.items().tooltip() == "A map of normals must have red and green: grey alone.");
    r.play("key Enter\nframes 3");
    CHECK(r.designer().pictures.talking());
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().pictures.talking());
    CHECK(r.designer().document.design == before);
}

TEST_CASE("picture: it becomes a layer of its shape and a stamp, or the chosen layer's modulation") {
    FolderRig r;
    const std::vector<float> rgb = {1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1};
    write_image(r.folder / "check.png", {2, 2}, rgb);
    r.play(r.drop("check.png") + r.import("Stamp"));
    REQUIRE(r.layers().size() == 2);
    CHECK(r.layers()[1].name == "check");
    CHECK(raster_mass(*std::get<PaintedLobe>(r.layers()[1].lobe).image.raster) > 0.1);
    REQUIRE(r.canvas().stamp < r.canvas().stamps.size());
    CHECK(r.canvas().stamps[r.canvas().stamp].name == "check");
    const Design before = r.document().design;
    r.play("click \"Stamp\"\nclick \"Canvas\":@0,0\nwait");
    CHECK(r.document().design != before);
    r.play("click \"Layer 1\"\n" + r.drop("check.png") + r.import("Modulation"));
    CHECK(r.layers()[0].modulation.has_value());
    CHECK(r.stage.designer().baker.problem().empty());
}

TEST_CASE("picture: the smoothing and the height of a map are set in the question, and stay set") {
    FolderRig r;
    write_grooves(r.folder / "grooves.exr");
    const std::string drop = r.drop("grooves.exr");
    const auto answer = [&](const std::string& first) {
        r.play(drop + r.card("Heights") + first + r.accept());
        return spread(r.layers().back());
    };
    const glm::dvec2 usual = answer("");
    // 2 % of the width in a sixteenth of it.
    const double slope = 0.02 * 16;
    const double degree = 3.14159265358979 / 180;
    CHECK(usual.x == doctest::Approx(slope / std::hypot(1, slope)).epsilon(0.02));
    CHECK(usual.y == doctest::Approx(1.5 * degree).epsilon(0.05));
    const glm::dvec2 smooth = answer("drag \"Smoothing\":0.5 \"Smoothing\":0.93\nframes 3\n");
    CHECK(smooth.y / (6 * degree) == doctest::Approx(1).epsilon(0.05));
    const glm::dvec2 rough = answer("drag \"Height\":0.5 \"Height\":1\nframes 3\n");
    CHECK(rough.x > 2 * usual.x);
    CHECK(rough.y > 2 * usual.y);  // the smoothing stayed
    const glm::dvec2 reset = answer(
        "frames 30\nclick \"Height\"\nclick \"Height\"\nframes 30\n"
        "click \"Smoothing\"\nclick \"Smoothing\"\nframes 3\n");
    CHECK(reset == usual);
}

TEST_CASE("picture: a wide one paints and modulates as wide as it is") {
    FolderRig r;
    write_image(r.folder / "wide.exr", {8, 2}, std::vector<float>(48, 1));
    const std::string drop = r.drop("wide.exr");
    r.play(drop + r.import("Stamp"));
    REQUIRE(r.layers().size() == 2);
    const glm::dvec2 painted = spread(r.layers()[1]);
    CHECK(painted.x / painted.y > 3);
    CHECK(painted.x / painted.y < 5);
    r.layers()[0].lobe = UniformLobe{};
    r.play("click \"Layer 1\"\n" + drop + r.import("Modulation"));
    REQUIRE(r.layers()[0].modulation);
    const glm::dvec2 modulated = spread(r.layers()[0]);
    CHECK(modulated.x / modulated.y > 2);
}

TEST_CASE("picture: what is none is told, and nothing changes") {
    FolderRig r;
    std::ofstream(r.folder / "words.png") << "not a picture";
    const Design before = r.stage.designer().document.design;
    r.play(r.drop("words.png"));
    CHECK(r.stage.designer().pictures.talking());
    CHECK(
        r.stage.designer().pictures.problem().starts_with("\u201cwords.png\u201d cannot be used. A text, "));
    r.play("key Enter\nframes 3");
    CHECK(!r.stage.designer().pictures.talking());
    r.play(r.drop("words.png") + "key Escape\nframes 3");
    CHECK(!r.stage.designer().pictures.talking());
    CHECK(r.stage.designer().document.design == before);
}
