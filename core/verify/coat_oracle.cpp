#include "core/verify/coat_oracle.h"

#include "core/bake/bake.h"
#include "core/bake/coat_lobe.h"

namespace nacre {

CoatOracle::CoatOracle(const Design& design) : tables_(bake(design)) {}

dvec3 CoatOracle::inside(dvec3 k) const { return tables_->shading.refracted(k); }

Shading<double>::Direction CoatOracle::direction(dvec3 k) const {
    auto a = tables_->shading.direction(k);
    a.coat_R = coat_albedo(tables_->shading, k.z);
    a.passed = tables_->shading.coat_way(a.k.z) * (1 - a.coat_R);
    return a;
}

dvec3 CoatOracle::passage(dvec3 k1, dvec3 k2) const {
    return tables_->shading.coat_passage(direction(k1), direction(k2));
}

dvec3 CoatOracle::reflection(dvec3 k1, dvec3 k2) const {
    return tables_->shading.coat_reflection(direction(k1), direction(k2));
}

}  // namespace nacre
