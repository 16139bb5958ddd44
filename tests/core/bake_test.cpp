// Tables against the reference, and the bake as a process.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/base/error.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design grooves(double width) {
    return with_layer(design_of(GaussianLobe{width, width}, 20, 0), GaussianLobe{width, width}, 1, 20, 180);
}

Design satin() {
    Design design = design_of(GaussianLobe{0.1, limits::infinity});
    design.distribution.layers[0].weight = 0.7;
    return with_layer(design, GaussianLobe{0.3, limits::infinity}, 0.3);
}

Design checkered() {
    return design_of(PaintedLobe{picture_of(
        32, [](double x, double y) { return std::cos(9 * x) * std::cos(7 * y) > 0 ? 1.0 : 0.1; })});
}

}  // namespace

TEST_SUITE_BEGIN("bake");

TEST_CASE("g and R of the tables agree with the reference") {
    struct Case {
        const char* name;
        Design design;
    };
    const Case cases[] = {{"needle", design_of(GaussianLobe{1e-3, 1e-3})},
                          {"wide", design_of(GaussianLobe{10, 10})},
                          {"brushed", design_of(GaussianLobe{0.1, 1})},
                          {"ggx", design_of(GgxLobe{0.1, 0.1})},
                          {"turned", design_of(GgxLobe{0.05, 0.4}, 0, 0, 33)},
                          {"velvet", design_of(InverseGaussianLobe{0.5})},
                          {"satin", satin()},
                          {"grooves", grooves(0.1)},
                          {"checkered", checkered()}};
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const auto tables = bake(c.design, {.albedo = true});
        const Shading<double>& shading = tables->shading;
        const Reference reference(c.design);
        Random random(11);
        for (int i = 0; i < 6; ++i) {
            const dvec3 k = i == 0 ? polar(1e-5, 0.3) : random_direction(random);
            const auto spot = shading.table_spot(k);
            const auto albedo = shading.albedo_spot(k, spot);
            const double g = shading.projected_area(k, spot), full = shading.albedo_f1(albedo);
            const AlbedoValues exact = reference.albedo(k);
            CHECK(std::fabs(g / reference.projected_area(k) - 1) < 1e-3);
            CHECK(std::fabs(full - exact[0]) < 2e-3);
            CHECK(std::fabs(shading.fresnel_albedo(albedo, full, shading.schlick_weight(k.z), 0) - exact[1]) <
                  3e-3);
        }
    }
}

TEST_CASE("the measured error of g is the error that other directions see") {
    struct Case {
        Design design;
        std::size_t bytes;  // the tables of the grooves need more than 64 KiB
    };
    for (const auto& [design, bytes] :
         {Case{design_of(GaussianLobe{0.1, 1}), 65536}, Case{satin(), 65536}, Case{grooves(0.01), 262144},
          Case{design_of(InverseGaussianLobe{0.3}), 65536}}) {
        const auto tables = bake(design);
        const FacetDistribution& p = *tables->distribution;
        Random random(12);
        double worst = 0;
        for (int i = 0; i < 2000; ++i) {
            const dvec3 k = random_direction(random);
            const double g = tables->shading.projected_area(k, tables->shading.table_spot(k));
            worst = std::fmax(worst, std::fabs(g / p.area(k).g - 1));
        }
        CHECK(worst < 1.25 * tables->errors.area.worst);
        CHECK(worst < 1e-3);
        CHECK(tables->table_floats() * sizeof(float) <= bytes);
    }
}

TEST_CASE("one thread and many bake the same bits") {
    Design design = satin();
    design.diffuse = CoupledDiffuse{};
    const auto one = bake(design, {.threads = 1}), many = bake(design, {.threads = 4});
    CHECK(one->data == many->data);
    CHECK(one->shading.surface.coupling == many->shading.surface.coupling);
}

TEST_CASE("a bake stops soon after it is asked to") {
    std::stop_source stop;
    Design design = with_layer(checkered(), GaussianLobe{0.02, 0.7}, 1, 30, 77);
    std::jthread asker([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        stop.request_stop();
    });
    const auto begin = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(bake(design, {.albedo = true, .threads = 1}, stop.get_token()), BakeCancelled);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(1));
}

TEST_CASE("symmetry is found where it is and nowhere else") {
    auto symmetry = [](const Design& design) { return find_symmetry(design.distribution).symmetry; };
    CHECK(symmetry(design_of(GaussianLobe{0.1, 0.1}, 0, 50, 20)) == Symmetry::isotropic);
    CHECK(symmetry(design_of(GaussianLobe{0.1, 0.2}, 0, 0, 20)) == Symmetry::quarter);
    CHECK(symmetry(grooves(0.1)) == Symmetry::quarter);
    CHECK(symmetry(design_of(GaussianLobe{0.1, 0.1}, 20, 30)) == Symmetry::half);
    CHECK(symmetry(design_of(GaussianLobe{0.1, 0.2}, 20, 30, 30)) == Symmetry::half);
    CHECK(symmetry(design_of(GaussianLobe{0.1, 0.2}, 20, 30)) == Symmetry::none);
    CHECK(symmetry(with_layer(grooves(0.1), GaussianLobe{0.1, 0.1}, 1, 20, 91)) == Symmetry::none);
    CHECK(symmetry(checkered()) == Symmetry::quarter);
    CHECK(symmetry(design_of(PaintedLobe{picture_of(
              8, [](double x, double y) { return x > 0.5 && y > 0.3 ? 1.0 : 0.0; })})) == Symmetry::none);
}

TEST_CASE("p scaled by 1e30 or 1e-30 is the same p") {
    Design design = satin();
    const auto plain = bake(design);
    for (const double scale : {1e-30, 1e30}) {
        Design scaled = design;
        for (Layer& layer : scaled.distribution.layers) layer.weight *= scale;
        const auto tables = bake(scaled);
        for (std::size_t i = 0; i < plain->data.size(); ++i)
            CHECK(tables->data[i] == doctest::Approx(plain->data[i]).epsilon(1e-6));
    }
}

TEST_CASE("facets that do not face up are refused by name") {
    CHECK_THROWS_AS(bake(design_of(GaussianLobe{0.1, 0.1}, 170)), UserError);
    const Design black = design_of(PaintedLobe{picture_of(4, [](double, double) { return 0.0; })});
    CHECK_THROWS_AS(bake(black), UserError);
}

TEST_CASE("a white furnace closes on the interpolant") {
    // F = 1 and a coupled diffuse term of albedo 1: what is not reflected once comes back diffuse.
    for (Design design : {design_of(GaussianLobe{0.1, 1}), design_of(GaussianLobe{1e-3, 0.5}),
                          design_of(GgxLobe{0.6, 0.6})}) {
        design.fresnel = NoFresnel{};
        design.diffuse = CoupledDiffuse{glm::dvec3{1}};
        const auto tables = bake(design);
        const Shading<double>& shading = tables->shading;
        // An independent rule: the midpoint in sin^2(theta) and phi.
        double rest = 0;
        constexpr int n = 600;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const dvec3 k = polar(std::sqrt(1 - (i + 0.5) / n), 2 * std::numbers::pi * (j + 0.5) / n);
                rest += 1 - shading.direction(k).R.x;
            }
        rest *= std::numbers::pi / n / n;
        CHECK(rest * shading.surface.coupling.x == doctest::Approx(1).epsilon(2e-4));
    }
}

TEST_SUITE_END();
