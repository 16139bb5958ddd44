// g of analytic lobes: area(), which is exact, against adaptive cubature of eq. 18 over the facets' theta and
// phi, of which a relative error of 1e-6 is wanted.
#include <cubature.h>
#include <fmt/core.h>

#include <algorithm>

#include "tests/bench/bench_designs.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

using std::numbers::pi;

constexpr double wanted_error = 1e-6;
constexpr std::size_t most_evaluations = 2'000'000;

struct Integrand {
    const FacetDistribution& facets;
    dvec3 k;
};

int projected_density(unsigned, const double* x, void* data, unsigned, double* value) {
    const Integrand& integrand = *static_cast<const Integrand*>(data);
    const double sine = std::sin(x[0]);
    const dvec3 h{sine * std::cos(x[1]), sine * std::sin(x[1]), std::cos(x[0])};
    const double seen = glm::dot(h, integrand.k);
    *value = seen > 0 ? seen * integrand.facets.density(h) * sine : 0;
    return 0;
}

// Of a p whose facets are all above the horizon. One quarter of the azimuth at a time: over the whole range
// the first points miss a narrow lobe, and cubature believes it is done.
double cubature_area(const FacetDistribution& facets, dvec3 k, double relative_error) {
    Integrand integrand{facets, k};
    double sum = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double low[] = {0, 0.5 * pi * quarter}, high[] = {0.5 * pi, 0.5 * pi * (quarter + 1)};
        double value = 0, error = 0;
        hcubature(1, projected_density, &integrand, 2, low, high, most_evaluations, 0, relative_error,
                  ERROR_INDIVIDUAL, &value, &error);
        sum += value;
    }
    return sum;
}

double worst_error(const FacetDistribution& facets, const std::vector<dvec3>& ks, double relative_error) {
    double worst = 0;
    for (const dvec3 k : ks) {
        const double exact = facets.area(k).g;
        worst = std::max(worst, std::fabs(cubature_area(facets, k, relative_error) - exact) / exact);
    }
    return worst;
}

void add(Report& report, const char* name, const Design& design) {
    const std::string what = fmt::format("g of {}: exact against cubature", name);
    add_benchmark(what, 5, [=, &report](benchmark::State& state) {
        const FacetDistribution facets(design.distribution);
        std::vector<dvec3> ks;
        for (int i = 0; i < 6; ++i) ks.push_back(test::polar(0.97 - 0.18 * i, 0.3 + i));
        // The loosest request that is met, in steps of a square root of ten.
        double request = 1e-3;
        double error = worst_error(facets, ks, request);
        while (error > wanted_error && request > 1e-9) {
            request /= std::sqrt(10.0);
            error = worst_error(facets, ks, request);
        }
        const auto each = [&](const auto& area) {
            for (const dvec3 k : ks) benchmark::DoNotOptimize(area(k));
        };
        const Pair pair = interleave(
            state, static_cast<double>(ks.size()), [&] { each([&](dvec3 k) { return facets.area(k).g; }); },
            [&] { each([&](dvec3 k) { return cubature_area(facets, k, request); }); });
        Line line = compared(what, pair);
        line.remark = fmt::format("cubature asked for {:.0e} has an error of {:.1e}", request, error);
        report.add(line);
    });
}

}  // namespace

void add_lobe_area(Report& report) {
    add(report, "Gaussian (0.1, 1)", brushed());
    add(report, "GGX (0.1, 0.3)", test::design_of(GgxLobe{0.1, 0.3}));
    add(report, "Beckmann (0.2, 0.4)", test::design_of(BeckmannLobe{0.2, 0.4}));
    add(report, "inverse Gaussian 0.5", test::design_of(InverseGaussianLobe{0.5}));
    add(report, "curve", test::design_of(CurveLobe{}));
}

}  // namespace nacre::bench
