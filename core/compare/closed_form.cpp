#include "core/compare/closed_form.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/compare/facet_slopes.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Shader = Shading<double>;
using Form = Shader::ClosedForm;

constexpr double erf_half = 0.47693627620446987;               // erf of it is 1/2
constexpr double widest = 1e3, narrowest = limits::width_min;  // slopes
constexpr int albedo_points = 4096, mean_points = 2048;

constexpr ClosedFormInfo models[] = {
    {ClosedFormModel::ward, "ward", "Ward", "Ward 1992, eq. 5a"},
    {ClosedFormModel::ggx, "ggx", "GGX", "Walter et al. 2007, eq. 33; Heitz 2014, eq. 99"},
    {ClosedFormModel::beckmann, "beckmann", "Beckmann", "Cook and Torrance 1982, eq. 14"},
    {ClosedFormModel::oren_nayar, "oren_nayar", "Oren-Nayar", "Oren and Nayar 1994, eq. 27 to 29"},
};

// Point i of `count` on the unit disk, evenly.
dvec2 disk_point(int i, int count) {
    const double r = std::sqrt((i + 0.5) / count), angle = pi * (3 - std::sqrt(5.0)) * i;
    return {r * std::cos(angle), r * std::sin(angle)};
}

dvec3 mean_albedo(const Shader& shading) {
    dvec3 sum{0};
    for (int i = 0; i < mean_points; ++i) {
        const dvec2 at = disk_point(i, mean_points);
        sum += shading.total_albedo(shading.direction({at, std::sqrt(1 - glm::dot(at, at))}));
    }
    return sum / static_cast<double>(mean_points);
}

// In the model's own axes. Oren and Nayar's: over directions spread as their cosine; the others': over facets
// of their own width, which mirror k.
dvec3 albedo_at(const Shader& shading, const Form& form, dvec3 k) {
    dvec3 sum{0};
    for (int i = 0; i < albedo_points; ++i) {
        const dvec2 at = disk_point(i, albedo_points);
        if (form.model == Shader::MODEL_OREN_NAYAR) {
            sum += pi * Shader::oren_nayar(form, k, {at, std::sqrt(1 - glm::dot(at, at))});
            continue;
        }
        // Even on the hemisphere, then stretched; dk2 = 4 (k.h) dh.
        const double z = 1 - glm::dot(at, at);
        const dvec3 stretched{form.width * at * std::sqrt(1 + z), z};
        const double size = glm::length(stretched), kh = glm::dot(k, stretched) / size;
        const dvec3 k2 = 2 * kh / size * stretched - k;
        if (kh <= 0 || k2.z <= 0) continue;
        const double solid_angle = 2 * pi * form.width.x * form.width.y / (size * size * size);
        sum += shading.closed_form_specular(form, k, k2) * (k2.z * 4 * kh * solid_angle);
    }
    return sum / static_cast<double>(albedo_points);
}

std::vector<float> albedo_tables(const Shader& shading, Form form) {
    constexpr int nodes = Shader::MODEL_NODES, azimuths = Shader::MODEL_AZIMUTHS;
    form.axis = {1, 0};
    std::vector<float> tables(static_cast<std::size_t>(3 * nodes * azimuths));
    for (int row = 0; row < azimuths; ++row)
        for (int node = 0; node < nodes; ++node) {
            const double phi = pi / 2 * row / (azimuths - 1), w = static_cast<double>(node) / (nodes - 1);
            // At grazing itself some of the models have no finite value.
            const double sine_to_cosine = std::min(w / (1 - w), 1e3);
            const dvec3 k =
                glm::normalize(dvec3{sine_to_cosine * std::cos(phi), sine_to_cosine * std::sin(phi), 1});
            const dvec3 albedo = albedo_at(shading, form, k);
            for (int channel = 0; channel < 3; ++channel)
                tables[static_cast<std::size_t>((channel * azimuths + row) * nodes + node)] =
                    static_cast<float>(albedo[channel]);
        }
    return tables;
}

}  // namespace

std::span<const ClosedFormInfo> all_closed_forms() { return models; }

const ClosedFormInfo& info(ClosedFormModel model) { return models[static_cast<std::size_t>(model)]; }

ClosedForm matching_form(const Tables& tables, ClosedFormModel model) {
    const FacetSlopes slopes = facet_slopes(*tables.distribution);
    const double scale = model == ClosedFormModel::ggx ? std::sqrt(3.0) : 1 / erf_half;
    ClosedForm made;
    Form& form = made.form;
    form.model = static_cast<int>(model);
    form.axis = {std::cos(slopes.azimuth), std::sin(slopes.azimuth)};
    form.width = glm::clamp(slopes.median * scale, narrowest, widest);
    form.inverse_width = 1.0 / form.width;
    form.scale = 1 / (pi * form.width.x * form.width.y);
    form.albedo_offset = -1;
    const Shader& shading = tables.shading;
    if (model == ClosedFormModel::oren_nayar) {
        assert(tables.needs.albedo);
        const double sigma = oren_nayar_sigma(*tables.distribution);
        form.sigma2 = sigma * sigma;
        form.rho = shading.kinds.matt_facets() ? dvec3{shading.surface.albedo * shading.surface.kd}
                                               : glm::min(mean_albedo(shading), dvec3{1});
    }
    if (tables.needs.albedo) {
        made.albedo = albedo_tables(shading, form);
        form.albedo_offset = static_cast<int>(tables.data.size());
    }
    return made;
}

dvec3 closed_form_brdf(const Shading<double>& shading, const Form& form, dvec3 k1, dvec3 k2) {
    if (k1.z <= 0 || k2.z <= 0) return dvec3{0};
    const auto a = shading.direction(k1), b = shading.direction(k2);
    const dvec3 rho = shading.closed_form_specular(form, a.k, b.k) + shading.closed_form_diffuse(form, a, b);
    if (!shading.kinds.coated()) return rho;
    return shading.coat_reflection(a, b) + shading.coat_passage(a, b) * rho;
}

}  // namespace nacre
