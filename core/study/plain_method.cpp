#include "core/study/plain_method.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr double rule_tolerance = 1e-3;
constexpr int samples = 4096;    // a direction
constexpr double lowest = 1e-6;  // c of the pairs that are counted

// The form of eq. 26, on the tables' g.
Shading<double> plain_form(const Tables& tables) {
    Shading<double> shading = tables.shading;
    shading.kinds.clamp = false;
    shading.kinds.masking = kind_index<MaskingModel, UncorrelatedMasking>();
    return shading;
}

}  // namespace

PlainMethod::PlainMethod(const Tables& tables, const std::stop_token& stop)
    : tables_(tables), grid_(PlainGrid(paper_polar, paper_azimuths, {})) {
    grid_.fill_area([&](int, dvec3 k) { return tables.distribution->area(k).g; }, stop);
}

double PlainMethod::specular(dvec3 k1, dvec3 k2) const {
    const dvec3 h = glm::normalize(k1 + k2);
    const double p = tables_.shading.density(h);
    return p * tables_.shading.surface.N / (4 * area(k1) * area(k2));
}

double PlainMethod::albedo(dvec3 k, int count, Random& random) const {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += specular(k, cosine_sample(random));
    return pi * sum / count;
}

PlainMethodErrors measure_plain_method(const Tables& tables, std::span<const DirectionPair> pairs,
                                       std::span<const dvec3> area_probes,
                                       std::span<const dvec3> albedo_probes, const std::stop_token& stop) {
    const PlainMethod plain(tables, stop);
    const Shading<double> form = plain_form(tables);
    PlainMethodErrors errors;
    for (const dvec3 k : area_probes)
        errors.area =
            worse_error(errors.area, area_error(form, k, plain.area(k), tables.distribution->area(k).g));
    const AlbedoQuadrature rule(*tables.distribution, form, 0, rule_tolerance);
    Random random(26);
    for (const dvec3 k : albedo_probes) {
        if (stop.stop_requested()) throw BakeCancelled();
        errors.albedo = worse_error(
            errors.albedo,
            std::fabs(plain.albedo(k, samples, random) - rule(k, tables.distribution->projected_area(k))[0]));
    }
    errors.unsound =
        static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [&](const DirectionPair& pair) {
            if (pair.k1.z < lowest || pair.k2.z < lowest) return false;
            const double rho = plain.specular(pair.k1, pair.k2);
            return !std::isfinite(rho) || rho < 0;
        }));
    return errors;
}

}  // namespace nacre
