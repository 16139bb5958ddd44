#include "tests/core/held_out.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/bake/albedo.h"
#include "core/verify/close_albedo.h"

namespace nacre::test {
namespace {

using std::numbers::pi;

HeldOutError held_out(double error, dvec3 k) {
    return {std::isnan(error) ? std::numeric_limits<double>::infinity() : error, k};
}

// The worst first.
template <class ErrorAt>
std::vector<HeldOutError> in_order(const std::vector<dvec3>& directions, const ErrorAt& error_at) {
    std::vector<HeldOutError> errors(directions.size());
    tbb::parallel_for(std::size_t{0}, directions.size(),
                      [&](std::size_t i) { errors[i] = held_out(error_at(directions[i]), directions[i]); });
    std::stable_sort(errors.begin(), errors.end(),
                     [](const HeldOutError& a, const HeldOutError& b) { return a.worst > b.worst; });
    return errors;
}

}  // namespace

std::vector<dvec3> held_out_directions(int count, unsigned seed) {
    Random random(seed);
    const double low = std::sin(3 * pi / 180);
    std::vector<dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double phi = 2 * pi * uniform_random(random), u = uniform_random(random);
        const double c = i % 4 == 0 ? std::sin(pi / 2 * u)
                         : i % 4 == 1
                             ? (i % 8 == 1 ? std::fmax(low * u, 1e-5) : low * std::pow(1e-5 / low, u))
                             : u;
        const double sine = std::sqrt((1 - c) * (1 + c));
        directions.push_back({sine * std::cos(phi), sine * std::sin(phi), c});
    }
    return directions;
}

Design random_mixture(unsigned seed) {
    Random random(seed);
    auto number = [&](double low, double high) { return low + (high - low) * uniform_random(random); };
    auto width = [&] { return std::exp(number(std::log(0.02), std::log(1.0))); };
    Design design;
    design.distribution.layers.clear();
    const int count = 1 + static_cast<int>(number(0, 4));
    for (int i = 0; i < count; ++i) {
        Layer layer;
        const double x = width(), y = number(0, 1) < 0.4 ? x : width();
        switch (static_cast<int>(number(0, 4))) {
            case 0:
                layer.lobe = GaussianLobe{x, y};
                break;
            case 1:
                layer.lobe = BeckmannLobe{x, y};
                break;
            default:
                layer.lobe = GgxLobe{x, y};
                break;
        }
        layer.weight = std::exp(number(std::log(2e-3), 0));
        layer.tilt = number(0, 60);
        layer.azimuth = number(0, 360);
        layer.rotation = number(0, 180);
        design.distribution.layers.push_back(layer);
    }
    design.shadowing.model = KindSet<MaskingModel>::made(static_cast<std::size_t>(number(0, 3)));
    design.fresnel = SchlickFresnel{dvec3{0.5}};
    design.diffuse = CoupledDiffuse{dvec3{0.5}};
    return design;
}

HeldOutError held_out_area(const Tables& tables, const std::vector<dvec3>& directions) {
    const auto errors = in_order(directions, [&](dvec3 k) {
        return area_error(tables.shading, k, tables.distribution->projected_area(k));
    });
    return errors.front();
}

HeldOutError held_out_albedo(const Design& design, const Tables& tables,
                             const std::vector<dvec3>& directions) {
    const int channels = tables.needs.fresnel_tables;
    const AlbedoQuadrature rule(*tables.distribution, tables.shading, channels, tables.tolerance / 40);
    const auto by_rule = in_order(directions, [&](dvec3 k) {
        return albedo_error(tables.shading, k, rule(k, tables.distribution->projected_area(k)), channels);
    });
    for (const PlacedLobe& placed : tables.distribution->lobes())
        if (placed.lobe->spans().empty()) return by_rule.front();
    const Reference reference(design);
    const CloseAlbedo exact_albedo(reference, tables.tolerance / 100);
    HeldOutError result;
    for (const HeldOutError& likely : by_rule) {
        if (likely.worst <= result.worst) break;
        const dvec3 k = likely.at;
        const HeldOutError exact = held_out(albedo_error(tables.shading, k, exact_albedo(k), channels), k);
        if (exact.worst > result.worst) result = exact;
    }
    return result;
}

}  // namespace nacre::test
