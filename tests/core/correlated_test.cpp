// R under eq. 14: t(phi) has a kink where k1 and k2 look to opposite sides.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/bake/bake.h"
#include "core/model/quadrature.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;
using std::numbers::pi;

namespace {

Design correlated(Lobe lobe, double width, double tilt = 0, double azimuth = 0) {
    Design design = design_of(std::move(lobe), tilt, azimuth);
    design.fresnel = NoFresnel{};
    design.shadowing.model = CorrelatedMasking{width};
    return design;
}

// visit(x, weight) over [begin, end]: Gauss points on `panels` equal parts, crowded toward both ends.
template <class Visit>
void for_each_point(double begin, double end, int panels, const Visit& visit) {
    for (int panel = 0; panel < panels; ++panel)
        for (const QuadraturePoint& point : gauss_legendre<16>()) {
            const double t = (panel + point.x) / panels;
            visit(begin + (end - begin) * t * t * t * (10 + t * (6 * t - 15)),
                  (end - begin) * 30 * t * t * (1 - t) * (1 - t) * point.weight / panels);
        }
}

// The thetas between which P1 - P2 keeps its sign on the meridian of phi.
std::vector<double> kinks_of(const Reference& reference, const Shading<double>::Direction& a, double phi) {
    const auto difference = [&](double theta) {
        return a.g * std::cos(theta) - a.k.z * reference.projected_area(polar(std::cos(theta), phi));
    };
    constexpr int steps = 40;
    std::vector<double> kinks = {0};
    for (int i = 0; i < steps; ++i) {
        double low = 0.5 * pi * i / steps, high = 0.5 * pi * (i + 1) / steps;
        const bool rises = difference(high) > 0;
        if (rises == (difference(low) > 0)) continue;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (low + high);
            ((difference(middle) > 0) == rises ? high : low) = middle;
        }
        kinks.push_back(high);
    }
    kinks.push_back(0.5 * pi);
    return kinks;
}

// Integral of rho c' over k' along its own meridians.
double albedo_over_directions(const Reference& reference, dvec3 k1, int panels) {
    const Shading<double>& shading = reference.shading();
    const auto a = Shading<double>::known_direction(k1, reference.projected_area(k1), dvec3{0});
    const double phi1 = std::atan2(k1.y, k1.x);
    double sum = 0;
    for (int half = 0; half < 2; ++half)
        for_each_point(phi1 + half * pi, phi1 + (half + 1) * pi, panels, [&](double phi, double step) {
            const std::vector<double> kinks = kinks_of(reference, a, phi);
            for (std::size_t i = 0; i + 1 < kinks.size(); ++i)
                for_each_point(kinks[i], kinks[i + 1], panels, [&](double theta, double weight) {
                    const dvec3 k2{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                   std::cos(theta)};
                    sum += step * weight * std::sin(theta) * std::cos(theta) *
                           shading
                               .specular(a, Shading<double>::known_direction(k2, reference.projected_area(k2),
                                                                             dvec3{0}))
                               .x;
                });
        });
    return sum;
}

}  // namespace

TEST_SUITE_BEGIN("correlated");

TEST_CASE("exact R under eq. 14 resolves the kink at 180 degrees, whatever the width") {
    for (const double width : {5.0, 15.0, 60.0, 120.0, 180.0}) {
        CAPTURE(width);
        for (const Lobe& lobe : {Lobe{GgxLobe{0.3, 0.3}}, Lobe{UniformLobe{}}}) {
            const Reference reference(correlated(lobe, width));
            for (const dvec3 k : {polar(0.98, 0.2), polar(0.3, 2.5), polar(0.006, 0.4)}) {
                CAPTURE(k.z);
                CHECK(std::fabs(reference.albedo(k)[0] - albedo_over_directions(reference, k, 4)) < 5e-7);
            }
        }
    }
}

TEST_CASE("exact R under eq. 14 of a lobe that leans: the kink cuts across its walk") {
    for (const double width : {15.0, 180.0}) {
        CAPTURE(width);
        for (const double tilt : {1e-6, 25.0}) {
            CAPTURE(tilt);
            Design design = correlated(GaussianLobe{0.6, 0.6}, width, tilt, 35);
            design.shadowing.clamp = false;  // a kink that no panel of the other quadrature follows
            const Reference reference(design);
            for (const dvec3 k : {polar(0.9, 0.2), polar(0.3, 2.5)}) {
                CAPTURE(k.z);
                CHECK(std::fabs(reference.albedo(k)[0] - albedo_over_directions(reference, k, 4)) < 5e-7);
            }
        }
    }
}

TEST_CASE("exact R with Smith's height correlation sees the layer beside the horizon") {
    Design design = correlated(GgxLobe{0.3, 0.3}, 15);
    design.shadowing.model = SmithCorrelatedMasking{};
    const Reference reference(design);
    for (const double c : {0.9, 0.05, 0.006}) {
        CAPTURE(c);
        const dvec3 k = polar(c, 0.4);
        CHECK(std::fabs(reference.albedo(k)[0] - albedo_over_directions(reference, k, 6)) < 5e-7);
    }
}

TEST_CASE("the bake's rule for R under eq. 14 keeps to its tolerance") {
    const double tolerance = 1e-4;
    for (const double width : {5.0, 60.0, 180.0}) {
        CAPTURE(width);
        for (const double tilt : {0.0, 25.0}) {
            CAPTURE(tilt);
            const Design design = correlated(GgxLobe{0.4, 0.4}, width, tilt, 35);
            const Reference reference(design);
            const auto tables = bake(design, {.tolerance = 2e-4});
            const AlbedoQuadrature rule(*tables->distribution, tables->shading, 0, tolerance);
            for (const dvec3 k : {polar(0.9, 0.2), polar(0.4, 2.5), polar(0.02, 0.4)}) {
                CAPTURE(k.z);
                const double g = reference.projected_area(k);
                // The rule reads g from the tables.
                const double most = 2 * tolerance + tables->errors.area.root_mean_square;
                CHECK(std::fabs(rule(k, g)[0] - reference.albedo(k)[0]) < most);
            }
        }
    }
}

TEST_SUITE_END();
