// Each method of computing and storing g and R against the truth.
#include <doctest/doctest.h>

#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/study/harmonic_area.h"
#include "core/study/method.h"
#include "core/study/plain_grid.h"
#include "core/verify/facet_integral.h"
#include "core/verify/reference.h"
#include "core/verify/table_error.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

// Worst relative error of g, and worst error of R with F = 1.
struct Errors {
    double area = 0, albedo = 0;
};

Errors errors_of(const Design& design, const MethodSetting& setting, Wanted wanted) {
    const StoredTable table = setting.make(wanted, {});
    const Reference reference(design);
    const auto tables = bake(design, {.quality = Quality::draft});
    Errors errors;
    for (const dvec3 k : probe_directions(100))
        errors.area = std::fmax(errors.area,
                                area_error(tables->shading, k, table.area(k), reference.projected_area(k)));
    if (wanted == Wanted::area_and_albedo)
        for (const dvec3 k : probe_directions(5))
            errors.albedo = std::fmax(errors.albedo, std::fabs(table.albedo(k)[0] - reference.albedo(k)[0]));
    return errors;
}

Design brushed() { return design_of(GgxLobe{0.15, 0.6}); }

}  // namespace

TEST_SUITE_BEGIN("report");

TEST_CASE("a plain grid gives back what is linear in theta and phi, in every symmetry") {
    for (const Symmetry symmetry : {Symmetry::isotropic, Symmetry::quarter, Symmetry::half, Symmetry::none}) {
        const PlainGrid grid(10, 20, {symmetry, 30});
        const int rows[] = {1, 6, 11, 20};
        CHECK(grid.size() == 10 * rows[static_cast<int>(symmetry)]);
        // Symmetric about the axis at 30 degrees, and bent nowhere but at nodes.
        auto height = [&](dvec3 k) {
            const double theta = std::acos(k.z);
            if (symmetry == Symmetry::isotropic) return theta;
            const double period = symmetry == Symmetry::quarter ? pi : 2 * pi;
            return theta * std::fabs(std::remainder(std::atan2(k.y, k.x) - pi / 6, period));
        };
        std::vector<float> nodes;
        for (int i = 0; i < grid.size(); ++i) nodes.push_back(static_cast<float>(height(grid.direction(i))));
        Random random(3);
        for (int i = 0; i < 200; ++i) {
            const dvec3 k = random_direction(random);
            CHECK(grid.value(nodes, k) == doctest::Approx(height(k)).epsilon(1e-5));
        }
    }
}

TEST_CASE("Monte Carlo comes closer with more samples, down to what the grid interpolates") {
    const Design design = design_of(GgxLobe{0.5, 0.5});
    const Method method = monte_carlo_method(design);
    const Errors few = errors_of(design, method.settings[1], Wanted::area_and_albedo);
    const Errors many = errors_of(design, method.settings[6], Wanted::area_and_albedo);
    CHECK(many.area < 0.2 * few.area);
    CHECK(many.albedo < 0.2 * few.albedo);
    // A node of g is the mean of pi p(h), whose standard deviation is about its own mean here: 65536 samples
    // leave 0.4 %, and the grid adds its own.
    const double grid = errors_of(design, plain_grid_method(design).settings[0], Wanted::area).area;
    CHECK(many.area < grid + 0.02);
}

TEST_CASE("cubature fills the 200-point grid with the exact g") {
    for (const Design& design : {brushed(), design_of(UniformLobe{}), slanted_velvet(1, true)}) {
        const FacetDistribution distribution(design.distribution);
        for (const double tolerance : {1e-3, 1e-6}) {
            const AdaptiveArea area(distribution, tolerance);
            for (const dvec3 k : probe_directions(6))
                CHECK(std::fabs(area(k, {}) - distribution.area(k).g) < tolerance);
        }
        const Errors grid = errors_of(design, plain_grid_method(design).settings[0], Wanted::area);
        const Errors cubature = errors_of(design, cubature_method(design).settings[3], Wanted::area);
        CHECK(cubature.area == doctest::Approx(grid.area).epsilon(0.02));
    }
}

TEST_CASE(
    "the reference of g is that of a ring in closed form, also where k grazes and turns from it at once") {
    for (const CurveLobe& ring :
         {CurveLobe{{{17, 0}, {21, 1}, {25, 0}}}, CurveLobe{{{2, 0}, {2.5, 1}, {3, 0}}},
          CurveLobe{{{60, 0}, {61, 1}, {62, 0}}}}) {
        const FacetDistribution p(design_of(ring).distribution);
        const AdaptiveArea area(p, 1e-9);
        Random random(6);
        for (const double c : {1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.3, 0.9}) {
            CAPTURE(c);
            const dvec3 k = polar(c, 2 * pi * uniform_random(random));
            CHECK(area(k, {}) == doctest::Approx(p.projected_area(k)).epsilon(1e-8));
        }
    }
}

TEST_CASE("plain and stretched grids of twice the nodes have a quarter of the error") {
    const Design design = brushed();
    for (const Method& method : {plain_grid_method(design), stretched_method(design)}) {
        CAPTURE(method.name);
        const double first = errors_of(design, method.settings[1], Wanted::area).area;
        const double second = errors_of(design, method.settings[3], Wanted::area).area;
        CHECK(second < first / 6);
        const double coarse = errors_of(design, method.settings[0], Wanted::area_and_albedo).albedo;
        const double fine = errors_of(design, method.settings[2], Wanted::area_and_albedo).albedo;
        CHECK(fine < coarse / 2);
    }
}

TEST_CASE("the stretched tables' error does not depend on p's width, that of the plain grid does") {
    const Design wide = design_of(GgxLobe{0.5, 0.5}), narrow = design_of(GgxLobe{0.005, 0.005});
    auto error = [](const Design& design, const Method& method, std::size_t setting) {
        return errors_of(design, method.settings[setting], Wanted::area).area;
    };
    const std::size_t nodes_33 = 3, nodes_37 = 2;
    CHECK(error(narrow, stretched_method(narrow), nodes_33) <
          1.5 * error(wide, stretched_method(wide), nodes_33));
    CHECK(error(narrow, plain_grid_method(narrow), nodes_37) >
          30 * error(wide, plain_grid_method(wide), nodes_37));
}

TEST_CASE("the bake's draft and final are what bake() gives") {
    const Design design = brushed();
    const Method method = bake_method(design);
    REQUIRE(method.settings.size() == 2);
    const auto final = bake(design, {.albedo = true});
    const StoredTable table = method.settings[1].make(Wanted::area_and_albedo, {});
    CHECK(table.bytes == final->table_floats() * sizeof(float));
    const dvec3 k = polar(0.3, 1.1);
    CHECK(table.area(k) == final->shading.projected_area(k, final->shading.table_spot(k)));
    CHECK(table.albedo(k) == read_albedo(final->shading, k, final->needs.fresnel_tables));
    CHECK(method.settings[0].make(Wanted::area, {}).bytes < table.bytes / 4);
}

TEST_CASE("the harmonics obey Unsoeld's theorem, and the zonal ones are those of Boost") {
    const HarmonicBasis basis(12, false);
    CHECK(basis.size() == 1 + 3 + 5 + 9 + 13 + 17 + 21 + 25);
    std::vector<double> values(basis.size());
    const double theta = 0.7, phi = 2.1;
    basis.evaluate({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
                   values);
    // Each degree's sum of squares is (2 l + 1)/(4 pi), by Unsoeld's theorem.
    for (const int degree : {0, 1, 2, 8, 12}) {
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (basis.degree_of(i) == degree) sum += values[i] * values[i];
        CHECK(sum == doctest::Approx((2 * degree + 1) / (4 * pi)).epsilon(1e-12));
    }
    const HarmonicBasis round(12, true);
    std::vector<double> zonal(round.size());
    round.evaluate({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
                   zonal);
    for (std::size_t i = 0; i < zonal.size(); ++i) {
        const auto degree = static_cast<unsigned>(round.degree_of(i));
        CHECK(zonal[i] ==
              doctest::Approx(boost::math::spherical_harmonic_r(degree, 0, theta, 0.0)).epsilon(1e-12));
    }
}

TEST_CASE("the clamped cosine's factors are those of Ramamoorthi and Hanrahan") {
    const double factors[] = {pi, 2 * pi / 3, pi / 4, 0, -pi / 24, 0, pi / 64};
    for (int degree = 0; degree < 7; ++degree)
        CHECK(clamped_cosine_factor(degree) == doctest::Approx(factors[degree]).epsilon(1e-14));
}

TEST_CASE("g by harmonics is the closed form of g where p is smooth") {
    SUBCASE("uniform hemisphere: g = (1 + c)/4 has no degree above 1") {
        const FacetDistribution p(design_of(UniformLobe{}).distribution);
        const HarmonicArea area(p, 2, true, {});
        for (const dvec3 k : probe_directions(40))
            CHECK(area(k) == doctest::Approx((1 + k.z) / 4).epsilon(1e-12));
    }
    SUBCASE("GGX of 0.7: g = N (c + r)/2") {
        const FacetDistribution p(design_of(GgxLobe{0.7, 0.7}).distribution);
        for (const auto& [degree, bound] : {std::pair{8, 1e-3}, {16, 1e-6}, {32, 1e-10}}) {
            const HarmonicArea area(p, degree, true, {});
            for (const dvec3 k : probe_directions(40)) {
                const double r = std::sqrt(0.49 * (1 - k.z * k.z) + k.z * k.z);
                CHECK(std::fabs(area(k) / (p.mean_cosine() * (k.z + r) / 2) - 1) < bound);
            }
        }
    }
    SUBCASE("turned and leaning: the same as the bake's own g") {
        Design design = design_of(GgxLobe{0.5, 0.8}, 25, 40, 10);
        const FacetDistribution p(design.distribution);
        const HarmonicArea area(p, 32, false, {});
        CHECK(area.upper_half() < 1e-3);
        for (const dvec3 k : probe_directions(40)) CHECK(std::fabs(area(k) - p.area(k).g) < 3e-4);
    }
}

TEST_CASE("harmonics are left out, and say so, where p is too narrow for their degree") {
    const Design needle = design_of(GgxLobe{0.002, 0.002}), smooth = design_of(GgxLobe{0.5, 0.5});
    const Method left_out = harmonic_method(needle, {});
    CHECK(left_out.settings.empty());
    CHECK(left_out.left_out.find("too narrow") != std::string::npos);
    const Method kept = harmonic_method(smooth, {});
    CHECK(kept.left_out.empty());
    double last = 1e9;
    for (int i : {0, 2, 4}) {
        const double error = errors_of(smooth, kept.settings[static_cast<std::size_t>(i)], Wanted::area).area;
        CHECK(error < 0.1 * last);
        last = error;
    }
}

TEST_SUITE_END();
