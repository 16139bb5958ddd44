// The errors that a bake claims hold on directions that took no part in it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

#include "core/bake/bake.h"
#include "core/bake/fitted.h"
#include "core/bake/worst_search.h"
#include "core/design/design_file.h"
#include "core/study/extremes.h"
#include "core/verify/reference.h"
#include "core/verify/table_error.h"
#include "tests/core/designs.h"
#include "tests/core/held_out.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

#ifdef NACRE_SANITIZED
constexpr int fewer = 20;
constexpr bool slow = true;
#else
constexpr int fewer = 1;
constexpr bool slow = false;
#endif

const std::filesystem::path source = NACRE_SOURCE_DIR;

// `slow`: instrumented, when what bakes for long is left to the plain build.
// R takes a hundred times as long as g.
void check_claims(const Design& design, int area_directions, int albedo_directions) {
    const auto tables = bake(design, {.albedo = true});
    const HeldOutError g = held_out_area(*tables, held_out_directions(area_directions / fewer, 31)),
                       R = held_out_albedo(design, *tables,
                                           held_out_directions(albedo_directions / fewer, 32));
    CHECK(g.worst <= allowed_error(tables->errors.area, tables->tolerance));
    CHECK(R.worst <= allowed_error(tables->errors.albedo, tables->tolerance));
    CHECK(tables->table_floats() * sizeof(float) <= 262144);
}

void check_presets(std::initializer_list<const char*> names, int albedo_directions) {
    for (const char* name : names) {
        CAPTURE(name);
        const Design design = load_design(source / "presets" / (std::string(name) + ".nacre"));
        check_claims(design, 20000, albedo_directions);
        const auto tables = bake(design);
        CHECK(tables->errors.area.worst <= tables->tolerance);
    }
}

// A value at each node of 9 x 8 nodes round a full turn.
template <class Function>
std::vector<float> nodes_of(const Function& value) {
    std::vector<float> values;
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 9; ++column) values.push_back(static_cast<float>(value(column, row)));
    return values;
}

constexpr TableNodes few_nodes{9, 8};

// Tables by name of their size alone: the error of each at the directions of its first measurement, and
// anywhere.
struct ToldTables {
    using Result = Fitted<int>;
    double first_of_small, first_of_large, small, large;

    bool is_small(TableNodes nodes) const { return nodes.polar <= 25; }
    Result make(TableNodes nodes) {
        const double worst = is_small(nodes) ? first_of_small : first_of_large;
        return {nullptr, {{worst, worst, 1}, worst, 0}, nodes};
    }
    void search(Result& result) { result.error.all.worst = shared(result); }
    double shared(const Result& result) const { return is_small(result.nodes) ? small : large; }
};

}  // namespace

TEST_SUITE_BEGIN("claims");

TEST_CASE("claims hold: round presets") {
    check_presets({"chrome", "copper", "ggx-steel", "matt-ceramic", "moon-ring", "velvet"}, 400);
}

TEST_CASE("claims hold: mirrored presets" * doctest::skip(slow)) {
    check_presets({"brushed-gold", "gold-painted-plastic", "grooved-metal", "satin"}, 1000);
}

TEST_CASE("claims hold: painted presets") { check_presets({"smiley", "spiral", "star"}, 1000); }

TEST_CASE("claims hold: slanted velvet, whose R turns within its azimuths at the horizon" *
          doctest::skip(slow)) {
    check_presets({"slanted-velvet-crimson"}, 2000);
}

TEST_CASE("claims hold: a narrow lobe that leans" * doctest::skip(slow)) {
    check_claims(load_design(source / "tests/core/claims-leaning.nacre"), 20000, 1000);
}

TEST_CASE("claims hold: a leaning lobe cut by a picture" * doctest::skip(slow)) {
    check_claims(load_design(source / "tests/core/claims-modulated.nacre"), 10000, 200);
}

TEST_CASE("claims hold: random mixtures that lean" * doctest::skip(slow)) {
    for (const unsigned seed : {6u, 8u, 11u, 23u}) {
        CAPTURE(seed);
        check_claims(random_mixture(seed), 20000, 700);
    }
}

TEST_CASE("claims hold: R beside the horizon, where its table misses the tolerance most" *
          doctest::skip(slow)) {
    check_claims(random_mixture(339), 1000, 3000);
}

TEST_CASE("claims hold: R where the clamp sets in, whose edge is above the horizon and between rows" *
          doctest::skip(slow)) {
    check_claims(random_mixture(544), 1000, 4000);
}

TEST_CASE("claims hold: a curve that falls straight to 0 within a tenth of a degree and less") {
    for (const double end : {0.1, 0.001}) {
        CAPTURE(end);
        check_claims(design_of(CurveLobe{{{0, 1}, {end, 0}}}), 2000, 400);
    }
}

TEST_CASE(
    "next to n a correlated masking has a limit for every azimuth, which R's rows hold; n has one of them") {
    const Design design = random_mixture(11);
    REQUIRE(std::holds_alternative<CorrelatedMasking>(design.shadowing.model));
    const auto tables = bake(design, {.albedo = true});
    const Reference reference(design);
    const dvec3 n{0, 0, 1};
    const dvec2 axis = tables->shading.surface.tables.axis;
    const double at_normal = reference.albedo(n)[0];
    CHECK(at_normal == doctest::Approx(reference.albedo({1e-6 * axis, 1})[0]).epsilon(1e-4));
    CHECK(std::fabs(read_albedo(tables->shading, n, 1)[0] - at_normal) < 1e-3);
    const dvec3 other = polar(0.7, 2);
    const dvec3 along =
        reference.shading().specular(reference.direction({1e-6 * axis, 1}), reference.direction(other));
    const dvec3 exact = reference.shading().specular(reference.direction(n), reference.direction(other));
    CHECK(exact.x == doctest::Approx(along.x).epsilon(1e-4));
    for (const double phi : {0.3, 2.0, 4.4}) {
        const dvec3 k = polar(std::cos(1e-3), phi);
        CHECK(std::fabs(read_albedo(tables->shading, k, 1)[0] - reference.albedo(k)[0]) < 1e-3);
    }
}

TEST_CASE("a rule is refined where the directions that chose it missed a narrow range") {
    const Design design = design_of(GgxLobe{0.1, 1});
    // So many nodes that g adds nothing.
    const auto tables = bake(design, {.size = TableSize{257, 65, 9, 9}});
    AlbedoQuadrature rule(*tables->distribution, tables->shading, 1, 3e-4);
    const dvec3 k = polar(1.28e-5, 0.0620168);
    const double g = tables->distribution->projected_area(k);
    const double exact = Reference(design).albedo(k)[0];
    REQUIRE(std::fabs(rule(k, g)[0] - exact) > 2 * 3e-4);
    CHECK(rule.refine_at({k}, 1e-4));
    CHECK(std::fabs(rule(k, g)[0] - exact) < 3e-4);
    CHECK_FALSE(rule.refine_at({k}, 1e-4));
}

TEST_CASE("what is linear between its nodes bends nowhere, a fold in the cells that touch it") {
    const std::vector<double> weights(72, 1.0);
    for (const double bend :
         cell_bends(few_nodes, Symmetry::none,
                    nodes_of([](int column, int) { return 3 - 0.5 * column; }).data(), weights))
        CHECK(bend == 0);
    const auto fold = nodes_of([](int column, int) { return std::abs(column - 4); });
    const std::vector<double> bends = cell_bends(few_nodes, Symmetry::none, fold.data(), weights);
    for (int cell = 0; cell < 64; ++cell) {
        const int column = cell % 8;
        CHECK(bends[static_cast<std::size_t>(cell)] == (column == 3 || column == 4 ? 0.25 : 0.0));
    }
}

TEST_CASE("the comb beside the horizon has teeth in the last cell of every row, close to both its ends") {
    for (const Symmetry symmetry : {Symmetry::isotropic, Symmetry::half, Symmetry::none}) {
        const TableCells cells({9, symmetry == Symmetry::isotropic ? 1 : 8}, symmetry);
        std::map<double, std::vector<double>> teeth;  // of a row, cells from the horizon
        for (const TablePoint& point : cells.beside_horizon(2))
            teeth[point.row].push_back(cells.columns() - point.column);
        CHECK(teeth.begin()->first == 0);
        CHECK(teeth.rbegin()->first == (cells.flat()     ? 0
                                        : cells.closed() ? cells.rows() - 0.5
                                                         : cells.rows()));
        double row = -0.5;
        for (const auto& [at, distances] : teeth) {
            CHECK(at - row == 0.5);
            row = at;
            const auto [nearest, farthest] = std::minmax_element(distances.begin(), distances.end());
            CHECK(*nearest > 0);
            CHECK(*nearest < 0.005);
            CHECK(*farthest < 1);
            CHECK(*farthest >= 0.2);
        }
    }
}

TEST_CASE("a search finds an error that stands in no middle of a cell") {
    const TableCells cells(few_nodes, Symmetry::none);
    auto look_for = [&](double column, double row) {
        WorstSearch search(cells, [&](const std::vector<TablePoint>& points) {
            std::vector<double> errors;
            for (const TablePoint& p : points)
                errors.push_back(std::exp(-std::hypot(p.column - column, p.row - row)));
            return errors;
        });
        search.look_at(cells.one_a_cell());
        search.climb(3);
        return search.worst();
    };
    CHECK(look_for(2.2, 5.85) > 0.9);
    CHECK(look_for(7.97, 0.1) > 0.9);
}

TEST_CASE("a search stays above the lowest cosine") {
    CHECK(not_below_lowest({0, 0, 1}) == dvec3{0, 0, 1});
    const dvec3 k = not_below_lowest({0.6, 0.8, 0});
    CHECK(k.z == lowest_cosine);
    CHECK(glm::length(k) == doctest::Approx(1));
    CHECK(k.x / k.y == doctest::Approx(0.75));
}

TEST_CASE("of two tables the one with the smaller error at the same directions is kept") {
    const FitWishes wishes{1e-3, 1e-3, 4096, 4096};
    const TableNodes first{25, 1};
    // Measured at more directions than the small one, the better one looks worse at first.
    ToldTables larger_is_better{0.05, 0.06, 0.11, 0.06};
    TableFit<ToldTables> one(larger_is_better, Symmetry::isotropic, wishes);
    CHECK(one.within_limit(first).nodes.polar > 25);
    // And where a search finds the larger one no better, the small one is kept.
    ToldTables larger_is_worse{0.05, 0.01, 0.05, 0.2};
    TableFit<ToldTables> other(larger_is_worse, Symmetry::isotropic, wishes);
    CHECK(other.within_limit(first).nodes == first);
}

TEST_SUITE_END();
