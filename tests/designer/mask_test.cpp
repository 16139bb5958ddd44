// A layer's mask, painted with the tools of the canvas.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "tests/designer/canvas_rig.h"

using namespace nacre;
using nacre::test::CanvasRig;

namespace {

constexpr auto mask = LayerPart::mask;

struct MaskRig : CanvasRig {
    MaskRig() {
        // As wide as the canvas, so that there is something to hide everywhere.
        layers()[0].lobe = GaussianLobe{0.8, 0.8};
        document().commit();
        play("click \"Paint the mask\"\nframes 3");
        canvas().brush = {.radius = 10, .hardness = 0.9, .flow = 1};
    }
};

// The colour of the canvas in the window's picture.
glm::ivec3 colour_at(CanvasRig& r, const std::string& place) {
    r.play("move \"Canvas\":0.02,0.98\nframes 30");
    const ImVec4 canvas = *r.stage.items().rectangle("Canvas");
    const std::size_t comma = place.find(',');
    const float x = std::stof(place.substr(0, comma)), y = std::stof(place.substr(comma + 1));
    const auto column = static_cast<std::size_t>(canvas.x + x * (canvas.z - canvas.x));
    const auto row = static_cast<std::size_t>(canvas.y + y * (canvas.w - canvas.y));
    r.stage.frame();
    const std::vector<std::uint8_t> pixels = r.stage.pixels();
    const std::size_t index = (row * 1280 + column) * (pixels.size() / (1280 * 800));
    return {pixels[index], pixels[index + 1], pixels[index + 2]};
}

}  // namespace

TEST_CASE("mask: a new one shows all, and its layer keeps its share") {
    CanvasRig r;
    const Design before = r.document().design;
    r.play("click \"Paint the mask\"\nframes 3");
    CHECK(r.canvas().paints_mask);
    REQUIRE(r.layers()[0].modulation);
    CHECK(r.value(0, 0, 0, mask) == 1);
    CHECK(r.value(0, 89, 120, mask) == doctest::Approx(1));
    CHECK(r.layers()[0].weight == before.distribution.layers[0].weight);
    CHECK(r.canvas().tool == ui::CanvasTool::erase);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == before);
    // Without a mask the tools paint as ever.
    r.play("key B\nclick \"Canvas\":@40,0\nframes 3");
    CHECK(r.layers().size() == 2);
}

TEST_CASE("mask: brush, eraser, stamp, fill and gradient paint it in place of the lobe, one step each") {
    MaskRig r;
    const Layer lobe = r.layers()[0];
    const auto check_step = [&](const std::string& events, double theta, double phi, double value) {
        CAPTURE(events);
        const Design before = r.document().design;
        r.play(events + "\nframes 30");
        CHECK(r.layers().size() == 1);
        CHECK(r.layers()[0].lobe == lobe.lobe);
        CHECK(r.value(0, theta, phi, mask) == doctest::Approx(value).epsilon(0.02));
        const Design after = r.document().design;
        r.play("key Ctrl+Z\nframes 2");
        CHECK(r.document().design == before);
        r.play("key Ctrl+Y\nframes 2");
        CHECK(r.document().design == after);
    };
    check_step("key E\nframes 30\ndrag \"Canvas\":@40,0 \"Canvas\":@40,60 8", 40, 30, 0);
    CHECK(r.value(0, 40, 200, mask) == 1);
    CHECK(r.layers()[0].weight < lobe.weight);
    check_step("key B\nframes 30\ndrag \"Canvas\":@40,0 \"Canvas\":@40,60 8", 40, 30, 1);
    CHECK(r.layers()[0].weight == doctest::Approx(lobe.weight).epsilon(2e-3));
    r.canvas().brush.value = 0.25;
    r.canvas().tolerance = 1;
    check_step("key F\nframes 30\nclick \"Canvas\":@30,200", 80, 10, 0.25);
    CHECK(r.layers()[0].weight == doctest::Approx(0.25 * lobe.weight).epsilon(5e-3));
    r.canvas().brush.value = 1;
    check_step("key D\nframes 30\ndrag \"Canvas\":@60,180 \"Canvas\":@60,0 5", 60, 180, 1);
    CHECK(r.value(0, 0, 0, mask) == doctest::Approx(0.625).epsilon(0.02));
    r.canvas().brush.value = 0;
    check_step("key T\nframes 30\nclick \"Canvas\":@0,0", 4.25, 319, 0);
    r.play("wait");
    CHECK(r.designer().baker.problem().empty());
    CHECK(parse_design(design_json(r.document().design, "."), "test", ".") == r.document().design);
}

TEST_CASE("mask: hidden facets go and the others stay as many as they were") {
    MaskRig r;
    r.layers().emplace_back();
    r.layers()[1].lobe = GaussianLobe{0.3, 0.3};
    r.document().commit();
    r.play("frames 3");
    const auto density = [&](double theta, double phi) {
        const auto& layers = r.layers();
        double total = 0;
        for (const Layer& layer : layers)
            if (counts(layer)) total += layer.weight;
        return r.designer().frame.p->density(polar_direction(theta, phi)) * total;
    };
    const double there = density(30, 180), hidden = density(30, 0);
    r.play("key 1\nkey E\nframes 30\ndrag \"Canvas\":@30,350 \"Canvas\":@30,10 8\nframes 30");
    CHECK(density(30, 180) == doctest::Approx(there).epsilon(0.01));
    CHECK(density(30, 0) < 0.75 * hidden);
}

TEST_CASE("mask: hidden altogether its layer is left out, and is there again with the first that shows") {
    MaskRig r;
    r.play("click \"Add layer\"\nframes 2\nclick \"Add GGX\"\nkey 1\nframes 3");
    const double weight = r.layers()[0].weight;
    r.canvas().brush.value = 0;
    r.play("key F\nframes 30\nclick \"Canvas\":@30,30\nwait");
    CHECK(!r.layers()[0].enabled);
    CHECK(r.designer().baker.problem().empty());
    CHECK_NOTHROW(parse_design(design_json(r.document().design, "."), "test", "."));
    r.canvas().brush.value = 1;
    r.play("click \"Canvas\":@30,30\nwait");
    CHECK(r.layers()[0].enabled);
    CHECK(r.layers()[0].weight == doctest::Approx(weight));
    CHECK(r.value(0, 30, 200, mask) == 1);
}

TEST_CASE("mask: a selection limits it, Delete hides what is selected, a pick reads it") {
    MaskRig r;
    r.play(
        "key W\nframes 30\ndrag \"Canvas\":0.02,0.02 \"Canvas\":0.5,0.98 4\nframes 30\nkey Delete\nframes 3");
    CHECK(r.value(0, 40, 0, mask) == 0);
    CHECK(r.value(0, 40, 180, mask) == 1);
    r.play("key B\nframes 30");
    r.play_with(true, false, false, "click \"Canvas\":@40,0\nframes 30");
    CHECK(r.canvas().brush.value == 0);
    r.play_with(true, false, false, "click \"Canvas\":@40,180\nframes 30");
    CHECK(r.canvas().brush.value == 1);
    r.play("drag \"Canvas\":@40,90 \"Canvas\":@40,270 8\nframes 3");
    CHECK(r.value(0, 20, 180, mask) == 1);
}

TEST_CASE("mask: a picture in another unit keeps p when it is painted on") {
    CanvasRig r;
    auto picture = std::make_shared<Raster>(Raster{64, 64, std::vector<float>(64 * 64, 2.0f)});
    for (std::size_t i = 0; i < picture->values.size(); i += 3) picture->values[i] = 0.5f;
    r.layers()[0].modulation = Modulation{{{}, picture}, 0.4};
    r.document().commit();
    r.play("frames 3\nclick \"Paint the mask\"\nframes 3");
    const double before = r.designer().frame.p->density(polar_direction(4, 130));
    r.canvas().brush = {.radius = 5, .hardness = 1, .flow = 1};
    r.play("key B\nframes 30\nclick \"Canvas\":@70,0\nframes 3");
    CHECK(r.layers()[0].modulation->image.raster->width == painted_side);
    CHECK(r.designer().frame.p->density(polar_direction(4, 130)) == doctest::Approx(before).epsilon(0.05));
}

TEST_CASE("mask: the canvas says that it is painted, and veils what it hides") {
    MaskRig r;
    r.play("key E\nframes 30\nclick \"Canvas\":0.35,0.5\nframes 60");
    const auto is_teal = [](glm::ivec3 c) { return c.y > 60 && c.z > 60 && c.x < c.y; };
    CHECK(is_teal(colour_at(r, "0.35,0.5")));
    CHECK(!is_teal(colour_at(r, "0.65,0.5")));
    r.play("click \"Paint the mask\"\nframes 60");
    CHECK(!r.canvas().paints_mask);
    CHECK(!is_teal(colour_at(r, "0.35,0.5")));
}
