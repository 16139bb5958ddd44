// NaN must never pass for a small error.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "core/bake/bake.h"
#include "core/study/extreme_check.h"
#include "core/verify/albedo_check.h"
#include "core/verify/sampling_check.h"
#include "tests/core/copied_tables.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

const double none = std::nan("");

}  // namespace

TEST_SUITE_BEGIN("errors");

TEST_CASE("an error that is NaN is the largest, at any place in a list") {
    for (const std::vector<double>& errors :
         {std::vector<double>{none, 1e-4, 2e-4}, {1e-4, none, 2e-4}, {1e-4, 2e-4, none}}) {
        const TableError error = summarise(errors);
        CHECK(error.worst == limits::infinity);
        CHECK(error.root_mean_square == limits::infinity);
        CHECK(error.directions == 3);
    }
    CHECK(summarise({1e-4, 2e-4}).worst == 2e-4);
}

TEST_CASE("a g or R that is NaN has an infinite error") {
    for (const bool clamp : {false, true}) {
        CAPTURE(clamp);
        Design design = design_of(GaussianLobe{0.1, 1});
        design.shadowing.clamp = clamp;
        const auto tables = bake(design, {.quality = Quality::draft, .albedo = true});
        for (const double c : {0.0, 1e-5, 0.4, 1.0}) {
            const dvec3 k = polar(c, 0.3);
            const double g = tables->distribution->projected_area(k);
            CHECK(area_error(tables->shading, k, g, g) == 0);
            CHECK(area_error(tables->shading, k, none, g) == limits::infinity);
            CHECK(area_error(tables->shading, k, g, none) == limits::infinity);
            AlbedoValues exact = read_albedo(tables->shading, k, 1);
            CHECK(albedo_error(tables->shading, k, exact, 1) == 0);
            exact[0] = none;
            CHECK(albedo_error(tables->shading, k, exact, 1) == limits::infinity);
        }
    }
}

TEST_CASE("tables that hold NaN fail every check that reads them") {
    const Design design = design_of(GgxLobe{0.3, 0.3});
    const auto good = bake(design, {.albedo = true});
    const Reference reference(design);
    auto put_none = [](Tables& tables, int offset, int nodes) {
        tables.data[static_cast<std::size_t>(offset + nodes / 2)] = std::nanf("");
    };
    const auto area = copy_of(*good), albedo = copy_of(*good);
    const auto& shape = good->shading.surface.tables;
    put_none(*area, shape.area_offset, shape.nodes_w);
    CHECK(measure_table_errors(*area, reference).area.worst == limits::infinity);
    CHECK(measure_albedo(*area, reference, {}).violations > 0);
    put_none(*albedo, shape.albedo_offset, shape.nodes_v);
    CHECK(measure_table_errors(*albedo, reference, {}, {.albedo = 40}).albedo.worst == limits::infinity);
    for (int i = 0; i < shape.nodes_v; ++i) put_none(*albedo, shape.albedo_offset, 2 * i);
    CHECK(measure_sampling(*albedo, {}).mean == limits::infinity);
}

TEST_CASE("the check of sampling is of whole facets, whatever share of them the diffuse model leaves") {
    Design design = design_of(GgxLobe{0.3, 0.3});
    design.diffuse = LambertianDiffuse{.kd = 0.5, .ks = 0.25};
    CHECK(measure_sampling(*bake(design, {.albedo = true}), {}).mean < 0.02);
}

TEST_CASE("a claim allows the tolerance, or a quarter more than the bake measured") {
    CHECK(allowed_error({.worst = 5e-4}, 1e-3) == 1e-3);
    CHECK(allowed_error({.worst = 4e-3}, 1e-3) == 5e-3);
    CHECK(allowed_error({.worst = none}, 1e-3) == limits::infinity);
}

TEST_CASE("a bake that claims an infinite error has not made tables") {
    ExtremeCase extreme;
    extreme.design = design_of(GgxLobe{0.3, 0.3});
    extreme.area_claim = extreme.albedo_claim = limits::infinity;
    const auto tables = copy_of(*bake(extreme.design, {.albedo = true}));
    tables->errors.area.worst = limits::infinity;
    const ExtremeOptions cheap{.pairs = 10,
                               .probes = {.area = 20, .albedo = 1},
                               .rings = {.polar = 1, .azimuths = 1},
                               .plain_method = false};
    CHECK_FALSE(judge_tables(extreme, tables, cheap).holds());
}

TEST_SUITE_END();
