// Fits of a painted p by closed lobes.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/bake/bake.h"
#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/fit/fit_json.h"
#include "core/fit/fit_loss.h"
#include "core/fit/lobe_fit.h"
#include "core/model/polar_angles.h"
#include "tests/core/cheap.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

Design correlated(Design design) {
    design.shadowing.model = SmithCorrelatedMasking{};
    return design;
}

Design star() { return load_design(NACRE_SOURCE_DIR "/presets/star.nacre"); }

std::vector<LobeParameters> some_lobes() {
    return {{0.2, 0.15, -0.1, 0.9, 0.6, 0.4}, {-0.7, -0.6, 0.3, 0.2, -0.5, 0.8}, {0.1, 0, 0, 1.1, 0.1, 1}};
}

}  // namespace

TEST_CASE("the gradient of the loss is that of differences") {
    const auto tables = bake(design_of(GaussianLobe{0.4, 0.7}, 20, 30));
    const std::vector<FitPair> pairs = draw_fit_pairs(*tables, 500, 5);
    const ViewMask mask(*tables);
    std::vector<std::size_t> all(pairs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    Workers workers(1);
    for (const LobeShape shape : {LobeShape::beckmann, LobeShape::ggx})
        for (const LobeWeights weights : {LobeWeights::constant, LobeWeights::view}) {
            CAPTURE(name_of(shape));
            CAPTURE(name_of(weights));
            const ViewedLobe model(shape, weights, mask);
            const std::vector<LobeParameters> lobes = some_lobes();
            const Loss loss = fit_loss(model, lobes, pairs, all, workers);
            for (std::size_t i = 0; i < lobes.size(); ++i)
                for (std::size_t j = 0; j < lobes[i].size(); ++j) {
                    CAPTURE(i);
                    CAPTURE(j);
                    const double step = 1e-6;
                    std::vector<LobeParameters> more = lobes, less = lobes;
                    more[i][j] += step;
                    less[i][j] -= step;
                    const double difference = (fit_loss(model, more, pairs, all, workers).value -
                                               fit_loss(model, less, pairs, all, workers).value) /
                                              (2 * step);
                    // The tables of P and Beckmann's Lambda have corners, which differences cut.
                    CHECK(std::fabs(loss.gradient[i][j] - difference) < 2e-4 + 2e-3 * std::fabs(difference));
                }
        }
}

TEST_CASE("a lobe comes back from its parameters and from its frame") {
    const MixtureLobe lobe{0.7, 0.5, 0.2, 70, 25, 130};
    const MixtureLobe again = lobe_of(frame_of(parameters_of(frame_of(lobe))));
    CHECK(again.weight == doctest::Approx(lobe.weight));
    CHECK(again.alpha_x == doctest::Approx(lobe.alpha_x));
    CHECK(again.alpha_y == doctest::Approx(lobe.alpha_y));
    CHECK(again.rotation == doctest::Approx(lobe.rotation));
    CHECK(again.tilt == doctest::Approx(lobe.tilt));
    CHECK(again.azimuth == doctest::Approx(lobe.azimuth));
}

TEST_CASE("an untilted lobe is the height-correlated Smith BRDF") {
    const auto tables = bake(correlated(design_of(GgxLobe{0.5, 0.3}, 0, 0, 40)));
    LobeMixture mixture{LobeShape::ggx, LobeWeights::constant, {{1, 0.5, 0.3, 40, 0, 0}}};
    int compared = 0;
    for (const FitPair& pair : draw_fit_pairs(*tables, 2000, 9)) {
        CHECK(mixture.brdf(pair.v, pair.l) == doctest::Approx(pair.rho).epsilon(0.01));
        ++compared;
    }
    CHECK(compared > 1000);
    const dvec3 v = polar_direction(30, 10);
    CHECK(mixture.brdf(v, dvec3(v.x, v.y, -v.z)) == 0);
}

TEST_CASE("one lobe returns itself") {
    for (const LobeShape shape : {LobeShape::beckmann, LobeShape::ggx}) {
        const bool ggx = shape == LobeShape::ggx;
        const Design design = correlated(ggx ? design_of(GgxLobe{0.4, 0.2}, 0, 0, 30)
                                             : design_of(BeckmannLobe{0.4, 0.2}, 0, 0, 30));
        const LobeFit fit =
            fit_lobes(*bake(design), {.target = FitTarget::standard, .lobes = 1, .shape = shape});
        REQUIRE(fit.mixture.lobes.size() == 1);
        const MixtureLobe& lobe = fit.mixture.lobes[0];
        CHECK(lobe.weight == doctest::Approx(1).epsilon(0.02));
        CHECK(lobe.alpha_x == doctest::Approx(0.4).epsilon(0.02));
        CHECK(lobe.alpha_y == doctest::Approx(0.2).epsilon(0.02));
        CHECK(lobe.rotation == doctest::Approx(30).epsilon(0.02));
        CHECK(lobe.tilt == 0);
        CHECK(fit.misplaced < 0.01);
    }
}

TEST_CASE("the paper's Gaussian is one Beckmann lobe and no GGX lobe") {
    const FitSettings one{.target = FitTarget::standard, .lobes = 1};
    for (const double width : {0.1, 0.3}) {
        const auto tables = bake(correlated(design_of(GaussianLobe{width, width})));
        CHECK(fit_lobes(*tables, one).misplaced < 0.01);
    }
    const auto tables = bake(correlated(design_of(GaussianLobe{0.3, 0.3})));
    FitSettings ggx = one;
    ggx.shape = LobeShape::ggx;
    const LobeFit fit = fit_lobes(*tables, ggx);
    CHECK(fit.misplaced > 0.2);
    bool told = false;
    for (const std::string& note : fit_notes(fit, *tables))
        told = told || note.find("No number of GGX lobes") != std::string::npos;
    CHECK(told);
}

TEST_CASE("core and haze are two GGX lobes") {
    const Design design =
        correlated(with_layer(design_of(GgxLobe{0.08, 0.08}), GgxLobe{0.45, 0.45}, 0.4 / 0.6));
    const FitSettings two{.target = FitTarget::standard, .lobes = 2, .shape = LobeShape::ggx};
    const LobeFit fit = fit_lobes(*bake(design), two);
    CHECK(fit.misplaced < 0.06);
    CHECK(fit.mixture.lobes[0].alpha_x == doctest::Approx(0.08).epsilon(0.1));
    CHECK(fit.mixture.lobes[1].alpha_x == doctest::Approx(0.45).epsilon(0.2));
}

TEST_CASE("weights that follow the view have the star" * doctest::skip(cheap)) {
    const auto tables = bake(star());
    const LobeFit fit = fit_lobes(*tables, {.lobes = 32, .steps = 800});
    REQUIRE(fit.tried.size() == 2);
    CHECK(fit.tried[0].weights == LobeWeights::constant);
    CHECK(fit.tried[0].energy > 0.1);
    CHECK(fit.tried[1].energy < 0.065);
    CHECK(fit.mixture.weights == LobeWeights::view);
    CHECK(fit.misplaced == fit.tried[1].energy);
    CHECK(fit_notes(fit, *tables).empty());
    for (const MixtureLobe& lobe : fit.mixture.lobes) {
        CHECK(lobe.tile.size() == std::size_t{tile_side} * tile_side);
        CHECK(lobe.alpha_x <= 1);
        CHECK(lobe.alpha_y <= lobe.alpha_x);
    }
}

// Of 63 lobes on a wide p some begin with next to no facets, which must not make them needles of any weight.
TEST_CASE("more lobes than p needs do no harm" * doctest::skip(cheap)) {
    const auto tables = bake(load_design(NACRE_SOURCE_DIR "/presets/satin.nacre"));
    const LobeFit fit = fit_lobes(*tables, {.lobes = 63, .weights = LobeWeights::constant, .steps = 100});
    CHECK(fit.misplaced < 0.4);
    for (const MixtureLobe& lobe : fit.mixture.lobes) {
        CHECK(lobe.weight <= weight_max * (1 + 1e-9));
        CHECK(lobe.alpha_y >= 0.99 * alpha_min);
        CHECK(lobe.alpha_x <= 1);
    }
}

TEST_CASE("a fit is the same for any number of threads and again" * doctest::skip(cheap)) {
    const auto tables = bake(star());
    FitSettings settings{.lobes = 3, .steps = 20, .threads = 1};
    const LobeFit first = fit_lobes(*tables, settings);
    CHECK(fit_lobes(*tables, settings).mixture == first.mixture);
    settings.threads = 2;
    CHECK(fit_lobes(*tables, settings).mixture == first.mixture);
}

TEST_CASE("a fit is refused, stopped and followed") {
    const auto tables = bake(design_of(BeckmannLobe{0.3, 0.3}));
    CHECK_THROWS_AS(fit_lobes(*tables, {.lobes = 0}), UserError);
    CHECK_THROWS_AS(fit_lobes(*tables, {.lobes = 65}), UserError);
    CHECK_THROWS_AS(fit_lobes(*tables, {.target = FitTarget::standard, .weights = LobeWeights::view}),
                    UserError);
    std::stop_source stop;
    CHECK_THROWS_AS(fit_lobes(*tables, {.lobes = 2}, stop.get_token(),
                              [&](double done) {
                                  if (done > 0.5) stop.request_stop();
                              }),
                    BakeCancelled);
    double last = 0;
    fit_lobes(*tables, {.lobes = 1, .steps = 10}, {}, [&](double done) {
        CHECK(done >= last);
        last = done;
    });
    CHECK(last == doctest::Approx(1));
}

TEST_CASE("the file of a fit holds what was fitted") {
    const auto tables = bake(star());
    const LobeFit fit = fit_lobes(*tables, {.lobes = 2, .weights = LobeWeights::view, .steps = 10});
    const nlohmann::json json = nlohmann::json::parse(fit_json(fit));
    CHECK(json["target"] == "cycles");
    CHECK(json["family"] == "beckmann");
    CHECK(json["weights"] == "view");
    CHECK(json["misplaced"].get<double>() == doctest::Approx(fit.misplaced).epsilon(1e-5));
    REQUIRE(json["lobes"].size() == 2);
    CHECK(json["lobes"][1]["alpha_x"].get<double>() ==
          doctest::Approx(fit.mixture.lobes[1].alpha_x).epsilon(1e-5));
    CHECK(json["lobes"][0]["tile"].size() == std::size_t{tile_side} * tile_side);
    FitSettings constant{.lobes = 2, .weights = LobeWeights::constant, .steps = 10};
    CHECK_FALSE(nlohmann::json::parse(fit_json(fit_lobes(*tables, constant)))["lobes"][0].contains("tile"));
}
