// How a stamp stands, and what paint does to what is there.
#include "core/paint/stamps.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/model/facet_distribution.h"
#include "core/paint/brush.h"
#include "tests/core/random_directions.h"

using namespace nacre;

TEST_CASE("stamp: upright where it shines, whatever the layer's rotation and tilt are") {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        Layer layer;
        layer.rotation = 360 * uniform_random(random) - 180;
        layer.tilt = 80 * uniform_random(random);
        layer.azimuth = 360 * uniform_random(random) - 180;
        const glm::dmat3 frame = layer_frame(layer);
        dvec3 at = test::random_direction(random);
        if ((frame * at).z < -0.9) continue;
        const glm::dmat2 to_tip = stamp_from_layer(layer, at, {});
        CHECK(std::abs(glm::determinant(to_tip) - 1) < 1e-9);
        // The picture's up, carried to the surface, is the plain stamp's there: down, since it shines up.
        const auto up_of = [&](const Layer& of, dvec3 middle) {
            const dvec2 flat = glm::transpose(stamp_from_layer(of, middle, {})) * dvec2(0, 1);
            return layer_frame(of) * (shortest_rotation({0, 0, 1}, middle) * dvec3(flat, 0));
        };
        CHECK(glm::length(up_of(layer, at) - up_of(Layer{}, frame * at)) < 1e-9);
    }
    CHECK(stamp_from_layer(Layer{}, {0, 0, 1}, {}) == glm::dmat2(-1));
    const glm::dmat2 turned = stamp_from_layer(Layer{}, {0, 0, 1}, {.angle = 90, .flip = false});
    CHECK(glm::length(turned * dvec2(1, 0) - dvec2(0, 1)) < 1e-12);
}

TEST_CASE("brush: what paint combines to") {
    Brush brush{.radius = 8, .hardness = 0.5, .flow = 1, .value = 0.5};
    CHECK(painted(brush, 0.2, 1) == 0.5);
    CHECK(painted(brush, 0.9, 0.5) == doctest::Approx(0.7));
    brush.blend = Blend::add;
    CHECK(painted(brush, 0.2, 0.5) == doctest::Approx(0.45));
    CHECK(painted(brush, 0.9, 1) == 1);
    brush.blend = Blend::multiply;
    CHECK(painted(brush, 0.8, 1) == doctest::Approx(0.4));
    CHECK(painted(brush, 0.8, 0.5) == doctest::Approx(0.6));
    brush.blend = Blend::maximum;
    CHECK(painted(brush, 0.2, 1) == 0.5);
    CHECK(painted(brush, 0.7, 1) == 0.7);
}
