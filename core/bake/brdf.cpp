#include "core/bake/brdf.h"

namespace nacre {

dvec3 brdf_term(const Shading<double>& shading, const Shading<double>::Direction& a,
                const Shading<double>::Direction& b, Term term) {
    switch (term) {
        case Term::specular:
            return shading.specular(a, b) * shading.surface.ks;
        case Term::diffuse:
            return shading.diffuse(a, b);
        case Term::density:
            return dvec3{shading.mirroring_density(a, b)};
        case Term::masking1:
            return dvec3{shading.masking(a)};
        case Term::masking2:
            return dvec3{shading.masking(b)};
        case Term::fresnel:
            return shading.mirroring_fresnel(a, b);
        case Term::inverse_areas:
            return dvec3{shading.inverse_areas(a, b)};
        case Term::total:
            break;
    }
    return shading.brdf_of(a, b);
}

dvec3 Brdf::evaluate(dvec3 k1, dvec3 k2, Term term) const {
    if (k1.z <= 0 || k2.z <= 0) return dvec3{0};
    const Shading<double>& shading = tables_->shading;
    return brdf_term(shading, shading.direction(k1), shading.direction(k2), term);
}

double Brdf::diffuse_probability() const {
    return tables_->shading.kinds.diffuse == kind_index<Diffuse, NoDiffuse>() ? 0 : 0.5;
}

double Brdf::pdf(dvec3 k1, dvec3 k2) const {
    if (k1.z <= 0 || k2.z <= 0) return 0;
    const Shading<double>& shading = tables_->shading;
    const double g = shading.projected_area(k1, shading.table_spot(k1));
    const double specular = g > 0 ? shading.density(glm::normalize(k1 + k2)) / (4 * g) : 0;
    const double diffuse = diffuse_probability();
    return (1 - diffuse) * specular + diffuse * cosine_density(k2);
}

std::optional<BrdfSample> Brdf::sample(dvec3 k1, Random& random) const {
    return BrdfSampler(*this, k1)(random);
}

BrdfSampler::BrdfSampler(const Brdf& brdf, dvec3 k1)
    : brdf_(brdf), k1_(k1), facets_(brdf.tables().distribution->lobes(), k1) {}

std::optional<BrdfSample> BrdfSampler::operator()(Random& random) const {
    if (k1_.z <= 0) return {};
    dvec3 k2;
    if (uniform_random(random) < brdf_.diffuse_probability()) {
        k2 = cosine_sample(random);
    } else {
        if (facets_.area() <= 0) return {};
        const dvec3 h = facets_(random);
        k2 = glm::normalize(2 * glm::dot(k1_, h) * h - k1_);
    }
    const double density = brdf_.pdf(k1_, k2);
    if (k2.z <= 0 || density <= 0) return {};
    return BrdfSample{k2, brdf_.evaluate(k1_, k2) * (k2.z / density), density};
}

dvec3 Brdf::albedo(dvec3 k) const {
    const Shading<double>& shading = tables_->shading;
    if (!shading.kinds.albedo || k.z < 0) return dvec3{0};
    return shading.direction(k).R;
}

}  // namespace nacre
