#include "core/verify/reflected_radiance.h"

#include <cmath>
#include <numbers>

#include "core/bake/albedo.h"

namespace nacre {
namespace {

using std::numbers::pi;

constexpr int facet_points = 96;
constexpr int light_columns = 512;  // at least, whatever the picture has

}  // namespace

// One viewed point.
struct RadianceIntegral::View {
    const Shading<double>& shading;
    glm::dmat3 frame;
    Shading<double>::Direction viewer;
    double irradiance = 0;  // of the light's density

    std::vector<FacetWay> ways;  // of facets that the viewer sees

    // Of k1, 1/sr: visible facets, and light as the surface sees it.
    double facet_density(dvec3 k1) const {
        double sum = 0;
        for (const FacetWay& way : ways) sum += way.way.part * way.density(shading, k1);
        return sum;
    }
    double light_density(double density, double cosine) const {
        return irradiance > 0 ? density * cosine / irradiance : 0;
    }
    dvec3 reflected(dvec3 k1) const { return shading.coated_brdf_of(shading.direction(k1), viewer) * k1.z; }
};

RadianceIntegral::RadianceIntegral(std::shared_ptr<const Tables> tables,
                                   std::shared_ptr<const Environment> environment, int fineness)
    : tables_(std::move(tables)), environment_(std::move(environment)), fineness_(fineness) {
    const LatLong& picture = environment_->picture;
    LatLong grid{std::max(picture.width, light_columns) * fineness / 2,
                 std::max(picture.height, light_columns / 2) * fineness / 2,
                 {}};
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column) {
            const glm::dvec2 place((column + 0.5) / grid.width, (row + 0.5) / grid.height);
            const double solid_angle = texel_solid_angle(grid, row);
            const dvec3 radiance = radiance_at(picture, place);
            lights_.push_back({lat_long_direction(place), radiance * solid_angle,
                               environment_->light_density(radiance), solid_angle});
        }
}

dvec3 RadianceIntegral::over_light(const View& view) const {
    dvec3 sum{0};
    for (const Light& light : lights_) {
        const dvec3 k1 = light.direction * view.frame;
        if (k1.z <= 0 || light.density <= 0) continue;
        const double by_light = view.light_density(light.density, k1.z), by_facets = view.facet_density(k1);
        sum += view.reflected(k1) * light.radiance * (by_light / (by_light + by_facets));
    }
    return sum;
}

dvec3 RadianceIntegral::over_facets(const View& view, const FacetWay& way) const {
    const int points = facet_points * fineness_;
    const dvec3 k2 = way.k1;
    dvec3 sum{0};
    const auto add = [&](const Facet& facet, double weight) {
        const double kh = glm::dot(k2, facet.h);
        const dvec3 k1 = way.end(view.shading, facet.h);
        if (kh <= 0 || k1.z <= 0 || facet.mass <= 0) return;
        const dvec3 radiance = radiance_at(environment_->picture, lat_long_place(view.frame * k1));
        const double by_facets = view.facet_density(k1);
        const double by_light = view.light_density(environment_->light_density(radiance), k1.z);
        if (!(by_facets > 0)) return;
        // dk1 = 4 (k2.h) dh, of which this way's facets are p dh, and again as much by refraction as they are
        // then less dense.
        sum += view.reflected(k1) * radiance *
               (way.way.part * weight * facet.mass * kh / way.g / (by_facets + by_light));
    };
    for (const PlacedLobe& placed : way.distribution->lobes())
        for (const LobeParameterization& span : placed.lobe->domains()) {
            const GreatCircleQuadrature walk(placed, span, k2);
            for (int i = 0; i < 2 * points; ++i) {
                const GreatCircleQuadrature::Ray ray = walk.ray(walk.start() + pi * (i + 0.5) / points);
                const double step = (ray.end - ray.begin) / points;
                if (!(step > 0)) continue;
                for (int j = 0; j < points; ++j)
                    add(walk.facet(ray, ray.begin + step * (j + 0.5)), step * pi / points);
            }
        }
    return sum;
}

dvec3 RadianceIntegral::operator()(const glm::dmat3& frame, dvec3 k2) const {
    View view{tables_->shading, frame, tables_->shading.direction(k2), 0, facet_ways(*tables_, k2)};
    for (const Light& light : lights_)
        view.irradiance +=
            light.density * light.solid_angle * std::fmax(glm::dot(light.direction, frame[2]), 0.0);
    dvec3 sum = over_light(view);
    for (const FacetWay& way : view.ways) sum += over_facets(view, way);
    return sum;
}

}  // namespace nacre
