#include "core/paint/lobe_handles.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/model/facet_distribution.h"
#include "core/paint/brush.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

Layer layer_of(Lobe lobe, double tilt = 0, double azimuth = 0, double rotation = 0) {
    Layer layer;
    layer.lobe = std::move(lobe);
    layer.tilt = tilt;
    layer.azimuth = azimuth;
    layer.rotation = rotation;
    return layer;
}

dvec3 handle_at(const Layer& layer, HandleKind kind) {
    for (const Handle& handle : handles_of(layer))
        if (handle.kind == kind) return handle.at;
    FAIL("no such handle");
    return {};
}

}  // namespace

TEST_CASE("handles: a Gaussian's outline is where it has fallen to 1/e") {
    const Layer layer = layer_of(GaussianLobe{0.3, 0.1}, 35, 50, 20);
    const auto model = make_lobe(layer);
    for (double t = 0; t < 1; t += 0.05)
        CHECK(model->density(glm::transpose(layer_frame(layer)) * outline_at(layer, t)) ==
              doctest::Approx(std::exp(-1)));
}

TEST_CASE("handles: a pulled handle goes where it is pulled") {
    Random random(4);
    const std::vector<Lobe> lobes = {GaussianLobe{0.3, 0.1}, GgxLobe{0.2, 0.5}, BeckmannLobe{0.1, 0.1}};
    for (const Lobe& lobe : lobes)
        for (int i = 0; i < 40; ++i) {
            const Layer layer =
                layer_of(lobe, 80 * uniform_random(random), 300 * uniform_random(random) - 150,
                         300 * uniform_random(random) - 150);
            const dvec3 to = test::random_direction(random);
            const Layer leaning = pulled(layer, HandleKind::axis, handle_at(layer, HandleKind::axis), to);
            CHECK(glm::length(handle_at(leaning, HandleKind::axis) - to) < 1e-9);
            CHECK(leaning.lobe == layer.lobe);
            for (const HandleKind kind : {HandleKind::width_x, HandleKind::width_y}) {
                // A place on the half circle on which this end can lie.
                const double slope = std::exp(6 * uniform_random(random) - 5);
                const dvec3 along = kind == HandleKind::width_x ? dvec3{slope, 0, 1} : dvec3{0, slope, 1};
                const dvec3 end = layer_frame(layer) * glm::normalize(along);
                const Layer wider = pulled(layer, kind, handle_at(layer, kind), end);
                CHECK(glm::length(handle_at(wider, kind) - end) < 1e-9);
                CHECK(wider.tilt == layer.tilt);
                const LobeShape before = shape_of(layer.lobe).value(), after = shape_of(wider.lobe).value();
                CHECK(after.stretch == doctest::Approx(before.stretch).epsilon(1e-9));
                const Layer one = pulled(layer, kind, handle_at(layer, kind), end, true);
                const HandleKind other =
                    kind == HandleKind::width_x ? HandleKind::width_y : HandleKind::width_x;
                CHECK(glm::length(handle_at(one, kind) - end) < 1e-9);
                CHECK(glm::length(handle_at(one, other) - handle_at(layer, other)) < 1e-12);
            }
        }
}

TEST_CASE("handles: a carried layer moves as a rigid body, by the angle of the way") {
    Random random(6);
    for (int i = 0; i < 60; ++i) {
        const Layer layer = layer_of(GaussianLobe{0.3, 0.1}, i % 5 == 0 ? 0 : 70 * uniform_random(random),
                                     300 * uniform_random(random) - 150, 300 * uniform_random(random) - 150);
        const dvec3 from = test::random_direction(random), to = test::random_direction(random);
        const glm::dmat3 frame = layer_frame(layer), moved = layer_frame(carried(layer, from, to));
        const glm::dmat3 expected = shortest_rotation(from, to) * frame;
        for (int axis = 0; axis < 3; ++axis) CHECK(glm::length(moved[axis] - expected[axis]) < 1e-9);
    }
    const Layer upright = layer_of(GgxLobe{});
    const double twenty = 20 * 3.14159265358979 / 180;
    const Layer moved = carried(upright, {0, 0, 1}, {0, std::sin(twenty), std::cos(twenty)});
    CHECK(moved.tilt == doctest::Approx(20));
    CHECK(moved.azimuth == doctest::Approx(90));
}

TEST_CASE("straighten: the mean normal comes to n, and the angles between facets stay") {
    Distribution design;
    design.layers = {layer_of(GaussianLobe{0.3, 0.1}, 30, 70, 10), layer_of(GgxLobe{0.2, 0.2}, 50, -20)};
    design.layers[1].weight = 0.4;
    const FacetDistribution before(design);
    CHECK(std::hypot(before.mean().x, before.mean().y) > 0.2);
    straighten(design, before.mean());
    const FacetDistribution after(design);
    CHECK(std::hypot(after.mean().x, after.mean().y) < 1e-6);
    CHECK(glm::length(after.mean()) == doctest::Approx(glm::length(before.mean())).epsilon(1e-6));
    const auto cosine = [](const FacetDistribution& p) {
        return glm::dot(p.lobes()[0].frame[2], p.lobes()[1].frame[2]);
    };
    CHECK(cosine(after) == doctest::Approx(cosine(before)));
}

TEST_CASE("handles: the outline turns a lobe and its ends stay as far apart") {
    const Layer layer = layer_of(GaussianLobe{0.4, 0.1}, 30, 70, 10);
    REQUIRE(outline_turns(layer));
    const Layer turned = pulled(layer, HandleKind::outline, outline_at(layer, 0.1), outline_at(layer, 0.2));
    CHECK(turned.lobe == layer.lobe);
    const dvec3 a = glm::transpose(layer_frame(layer)) * outline_at(layer, 0.1);
    const dvec3 b = glm::transpose(layer_frame(layer)) * outline_at(layer, 0.2);
    const double by = (std::atan2(b.y, b.x) - std::atan2(a.y, a.x)) * 180 / 3.14159265358979;
    CHECK(turned.rotation == doctest::Approx(10 + by));
}

TEST_CASE("handles: the outline of a round lobe widens it both ways") {
    const Layer layer = layer_of(GgxLobe{0.2, 0.2}, 20, 0);
    REQUIRE(!outline_turns(layer));
    const dvec3 to = layer_frame(layer) * glm::normalize(dvec3{0.3, 0.4, 1});
    const Layer wider = pulled(layer, HandleKind::outline, outline_at(layer, 0.3), to);
    CHECK(std::get<GgxLobe>(wider.lobe).alpha_x == doctest::Approx(0.5));
    CHECK(std::get<GgxLobe>(wider.lobe).alpha_y == doctest::Approx(0.5));
    const Layer velvet = layer_of(InverseGaussianLobe{0.5});
    const dvec3 fibre = glm::normalize(dvec3{1, 0, 0.25});
    const Layer thinner = pulled(velvet, HandleKind::outline, outline_at(velvet, 0), fibre);
    CHECK(std::get<InverseGaussianLobe>(thinner.lobe).sigma == doctest::Approx(0.25));
}

TEST_CASE("handles: at the horizon a Gaussian's width is infinite, another's as large as can be") {
    const dvec3 horizon{1, 0, 0};
    const Layer gaussian = layer_of(GaussianLobe{0.1, 0.1});
    const Layer cylinder =
        pulled(gaussian, HandleKind::width_x, handle_at(gaussian, HandleKind::width_x), horizon);
    CHECK(std::isinf(std::get<GaussianLobe>(cylinder.lobe).sigma_x));
    CHECK(std::get<GaussianLobe>(cylinder.lobe).sigma_y == 0.1);
    CHECK(handle_at(cylinder, HandleKind::width_x).z < 0.02);
    const Layer back = pulled(cylinder, HandleKind::width_x, handle_at(cylinder, HandleKind::width_x),
                              glm::normalize(dvec3{1, 0, 1}));
    CHECK(std::get<GaussianLobe>(back.lobe).sigma_x == doctest::Approx(1));
    CHECK(std::get<GaussianLobe>(back.lobe).sigma_y == 0.1);
    const Layer ggx = layer_of(GgxLobe{0.1, 0.1});
    const Layer wide = pulled(ggx, HandleKind::width_x, handle_at(ggx, HandleKind::width_x), horizon);
    CHECK(std::isfinite(std::get<GgxLobe>(wide.lobe).alpha_x));
    CHECK(std::get<GgxLobe>(wide.lobe).alpha_x <= limits::width_max);
}

TEST_CASE("shape: softness and stretch set the widths of what has two, and are read back") {
    for (Lobe lobe : {Lobe(GaussianLobe{0.3, 0.1}), Lobe(GgxLobe{0.2, 0.5}), Lobe(BeckmannLobe{0.1, 0.1})}) {
        set_shape(lobe, {.softness = 0.25, .stretch = 4});
        const auto shape = shape_of(lobe);
        REQUIRE(shape);
        CHECK(shape->softness == doctest::Approx(0.25));
        CHECK(shape->stretch == doctest::Approx(4));
    }
    CHECK(!shape_of(GaussianLobe{0.1, limits::infinity}));
    CHECK(!shape_of(InverseGaussianLobe{0.5}));
    CHECK(!shape_of(UniformLobe{}));
    Lobe flat = UniformLobe{};
    set_shape(flat, {});
    CHECK(flat == Lobe(UniformLobe{}));
}
