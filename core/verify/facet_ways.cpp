#include "core/verify/facet_ways.h"

namespace nacre {

double FacetWay::density(const Shading<double>& shading, dvec3 k2) const {
    const dvec3 end = refracts ? shading.refracted(k2) : k2;
    const double p = distribution->density(glm::normalize(k1 + way.leaving(end))) / (4 * g);
    const double ior = shading.surface.coat_ior;
    return refracts ? p * k2.z / (ior * ior * end.z) : p;
}

dvec3 FacetWay::end(const Shading<double>& shading, dvec3 h) const {
    const dvec3 k2 = way.leaving(glm::normalize(2 * glm::dot(k1, h) * h - k1));
    return refracts && k2.z > 0 ? shading.emerging(k2) : k2;
}

std::vector<FacetWay> facet_ways(const Tables& tables, dvec3 k1) {
    std::vector<FacetWay> ways;
    const bool coated = tables.shading.kinds.coated();
    for (const MirrorWay& way : mirror_ways(tables.shading)) {
        const dvec3 from = way.entering(coated ? tables.shading.refracted(k1) : k1);
        const double g = tables.distribution->projected_area(from);
        if (way.part > 0 && g > 0) ways.push_back({way, tables.distribution.get(), coated, from, g});
    }
    if (coated)
        ways.push_back({{}, tables.coat_facets.get(), false, k1, tables.coat_facets->projected_area(k1)});
    return ways;
}

}  // namespace nacre
